(define (problem briefcase-small) (:domain briefcase)
  (:objects l0 l1 l2 - location o0 o1 o2 o3 - portable)
  (:init
    (is-at l0) (at o0 l0) (at o1 l2) (at o2 l0) (at o3 l2))
  (:goal (and
    (at o0 l2) (at o1 l1) (at o2 l1) (at o3 l0) (is-at l0))))

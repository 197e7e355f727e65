(define (problem briefcase-middle) (:domain briefcase)
  (:objects l0 l1 l2 l3 l4 l5 - location o0 o1 o2 o3 o4 o5 o6 o7 o8 o9 - portable)
  (:init
    (is-at l0) (at o0 l1) (at o1 l1) (at o2 l4) (at o3 l3) (at o4 l0) (at o5 l3) (at o6 l1) (at o7 l4)
    (at o8 l0) (at o9 l0))
  (:goal (and
    (at o0 l5) (at o1 l5) (at o2 l4) (at o3 l4) (at o4 l3) (at o5 l1) (at o6 l1) (at o7 l5) (at o8 l1)
    (at o9 l1) (is-at l0))))

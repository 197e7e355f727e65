(define (problem above-small) (:domain above)
  (:objects b0 b1 b3 b2 - block)
  (:init
    (on b1 b2) (on b0 b1) (on b3 b0) (ontable b2))
  (:goal (and
    (above b0 b1) (above b1 b3) (not (above b2 b3)))))

(define (problem above-middle) (:domain above)
  (:objects b9 b2 b0 b8 b5 b4 b1 b7 b6 b3 - block)
  (:init
    (on b4 b7) (on b3 b4) (on b1 b3) (on b5 b1) (on b9 b5) (on b6 b9) (on b2 b6) (on b8 b2) (on b0 b8)
    (ontable b7))
  (:goal (and
    (above b9 b2) (above b2 b0) (above b0 b8) (above b8 b5) (above b5 b4) (not (above b3 b6)))))

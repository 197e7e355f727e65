(define (problem flashfill-small) (:domain flashfill)
  (:objects
    e0 e1 - example i0 i1 i2 i3 - index sep45 s_a s_b s_c s_d - sign)
  (:init
    (= (total-cost) 0) (first i0) (next i0 i1) (next i1 i2) (next i2 i3) (separator sep45) (text e0 i0 s_a)
    (text e0 i1 s_b) (wanted e0 i0 s_b) (wanted e0 i1 sep45) (wanted e0 i2 s_a) (reads e0 i0) (writes e0 i0)
    (length e0 i3) (text e1 i0 s_c) (text e1 i1 s_d) (wanted e1 i0 s_d) (wanted e1 i1 sep45)
    (wanted e1 i2 s_c) (reads e1 i0) (writes e1 i0) (length e1 i3))
  (:goal (and
    (done e0) (done e1) (not (spoilt e0)) (not (spoilt e1))))
  (:metric minimize (total-cost)))

(define (problem flashfill-middle) (:domain flashfill)
  (:objects
    e0 e1 e2 - example i0 i1 i2 i3 i4 i5 - index sep46 s_a s_b s_c s_d s_e s_f s_g s_h - sign)
  (:init
    (= (total-cost) 0) (first i0) (next i0 i1) (next i1 i2) (next i2 i3) (next i3 i4) (next i4 i5)
    (separator sep46) (text e0 i0 s_a) (text e0 i1 s_b) (text e0 i2 s_c) (text e0 i3 s_d) (wanted e0 i0 s_d)
    (wanted e0 i1 sep46) (wanted e0 i2 s_c) (wanted e0 i3 s_a) (wanted e0 i4 s_b) (reads e0 i0)
    (writes e0 i0) (length e0 i5) (text e1 i0 s_e) (text e1 i1 s_f) (text e1 i2 s_g) (text e1 i3 s_h)
    (wanted e1 i0 s_h) (wanted e1 i1 sep46) (wanted e1 i2 s_g) (wanted e1 i3 s_e) (wanted e1 i4 s_f)
    (reads e1 i0) (writes e1 i0) (length e1 i5) (text e2 i0 s_a) (text e2 i1 s_b) (text e2 i2 s_e)
    (text e2 i3 s_f) (wanted e2 i0 s_f) (wanted e2 i1 sep46) (wanted e2 i2 s_e) (wanted e2 i3 s_a)
    (wanted e2 i4 s_b) (reads e2 i0) (writes e2 i0) (length e2 i5))
  (:goal (and
    (done e0) (done e1) (done e2) (not (spoilt e0)) (not (spoilt e1)) (not (spoilt e2))))
  (:metric minimize (total-cost)))

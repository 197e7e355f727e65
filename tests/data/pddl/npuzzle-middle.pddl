(define (problem npuzzle-middle) (:domain n-puzzle)
  (:objects
    p0 p1 p2 p3 p4 p5 p6 p7 p8 p9 p10 p11 p12 p13 p14 p15 - position t1 t2 t3 t4 t5 t6 t7 t8 t9 t10 t11 t12 t13 t14
    t15 - tile)
  (:init
    (neighbor p0 p1) (neighbor p1 p0) (neighbor p0 p4) (neighbor p4 p0) (neighbor p1 p2) (neighbor p2 p1)
    (neighbor p1 p5) (neighbor p5 p1) (neighbor p2 p3) (neighbor p3 p2) (neighbor p2 p6) (neighbor p6 p2)
    (neighbor p3 p7) (neighbor p7 p3) (neighbor p4 p5) (neighbor p5 p4) (neighbor p4 p8) (neighbor p8 p4)
    (neighbor p5 p6) (neighbor p6 p5) (neighbor p5 p9) (neighbor p9 p5) (neighbor p6 p7) (neighbor p7 p6)
    (neighbor p6 p10) (neighbor p10 p6) (neighbor p7 p11) (neighbor p11 p7) (neighbor p8 p9) (neighbor p9 p8)
    (neighbor p8 p12) (neighbor p12 p8) (neighbor p9 p10) (neighbor p10 p9) (neighbor p9 p13) (neighbor p13 p9)
    (neighbor p10 p11) (neighbor p11 p10) (neighbor p10 p14) (neighbor p14 p10) (neighbor p11 p15) (neighbor p15 p11)
    (neighbor p12 p13) (neighbor p13 p12) (neighbor p13 p14) (neighbor p14 p13) (neighbor p14 p15) (neighbor p15 p14)
    (at t13 p0) (at t12 p1) (at t14 p2) (at t9 p3) (at t5 p4) (empty p5) (at t3 p6) (at t4 p7) (at t10 p8) (at t1 p9)
    (at t6 p10) (at t8 p11) (at t2 p12) (at t11 p13) (at t7 p14) (at t15 p15))
  (:goal (and
    (at t1 p1) (at t2 p2) (at t3 p3) (at t4 p4) (at t5 p5) (at t6 p6) (at t7 p7) (at t8 p8) (at t9 p9) (at t10 p10)
    (at t11 p11) (at t12 p12) (at t13 p13) (at t14 p14) (at t15 p15))))

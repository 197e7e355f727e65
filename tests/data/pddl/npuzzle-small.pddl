(define (problem npuzzle-small) (:domain n-puzzle)
  (:objects
    p0 p1 p2 p3 p4 p5 p6 p7 p8 - position t1 t2 t3 t4 t5 t6 t7 t8 - tile)
  (:init
    (neighbor p0 p1) (neighbor p1 p0) (neighbor p0 p3) (neighbor p3 p0) (neighbor p1 p2) (neighbor p2 p1)
    (neighbor p1 p4) (neighbor p4 p1) (neighbor p2 p5) (neighbor p5 p2) (neighbor p3 p4) (neighbor p4 p3)
    (neighbor p3 p6) (neighbor p6 p3) (neighbor p4 p5) (neighbor p5 p4) (neighbor p4 p7) (neighbor p7 p4)
    (neighbor p5 p8) (neighbor p8 p5) (neighbor p6 p7) (neighbor p7 p6) (neighbor p7 p8) (neighbor p8 p7) (at t1 p0)
    (at t8 p1) (at t3 p2) (at t4 p3) (at t6 p4) (at t7 p5) (empty p6) (at t2 p7) (at t5 p8))
  (:goal (and
    (at t1 p1) (at t2 p2) (at t3 p3) (at t4 p4) (at t5 p5) (at t6 p6) (at t7 p7) (at t8 p8))))

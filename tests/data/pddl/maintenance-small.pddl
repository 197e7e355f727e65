(define (problem maintenance-small) (:domain maintenance-scheduling-domain)
  (:objects
    p0 p1 p2 p3 p4 p5 p6 p7 p8 p9 p10 p11 p12 p13 p14 p15 p16 p17 p18 p19 - plane d0 d1 d2 d3 d4 d5 d6 d7 d8 d9 - day
    a0 a1 a2 - airport)
  (:init
    (today d0) (next d0 d1) (next d1 d2) (next d2 d3) (next d3 d4) (next d4 d5) (next d5 d6) (next d6 d7)
    (next d7 d8) (next d8 d9) (at p0 d3 a1) (at p0 d1 a1) (at p1 d6 a1) (at p1 d0 a0) (at p2 d0 a2) (at p2 d9 a1)
    (at p3 d7 a1) (at p3 d4 a2) (at p4 d3 a1) (at p4 d9 a0) (at p5 d5 a1) (at p5 d0 a0) (at p6 d8 a0) (at p6 d0 a0)
    (at p7 d3 a1) (at p7 d6 a1) (at p8 d8 a0) (at p8 d0 a0) (at p9 d7 a1) (at p9 d7 a2) (at p10 d3 a1) (at p10 d5 a0)
    (at p11 d3 a1) (at p11 d7 a1) (at p12 d6 a2) (at p12 d0 a0) (at p13 d1 a2) (at p13 d2 a2) (at p14 d1 a2)
    (at p14 d4 a0) (at p15 d5 a1) (at p15 d8 a1) (at p16 d3 a1) (at p16 d8 a2) (at p17 d9 a1) (at p17 d4 a0)
    (at p18 d8 a2) (at p18 d6 a2) (at p19 d7 a0) (at p19 d0 a0))
  (:goal (and
    (done p0) (done p1) (done p2) (done p3) (done p4) (done p5) (done p6) (done p7) (done p8) (done p9) (done p10)
    (done p11) (done p12) (done p13) (done p14) (done p15) (done p16) (done p17) (done p18) (done p19))))

(define (problem trucksadl-small) (:domain trucks-adl)
  (:objects
    t0 - truck x0 x1 x2 - parcel p0 p1 p2 - place a0 a1 - area m0 m1 m2 m3 m4 m5 m6 m7 - moment)
  (:init
    (at t0 p0) (now m0) (road p0 p1) (road p0 p2) (road p1 p0) (road p1 p2) (road p2 p0) (road p2 p1)
    (nearer a0 a1) (free a0 t0) (free a1 t0) (next m0 m1) (next m1 m2) (next m2 m3) (next m3 m4)
    (next m4 m5) (next m5 m6) (next m6 m7) (not-later m0 m0) (not-later m0 m1) (not-later m1 m1)
    (not-later m0 m2) (not-later m1 m2) (not-later m2 m2) (not-later m0 m3) (not-later m1 m3)
    (not-later m2 m3) (not-later m3 m3) (not-later m0 m4) (not-later m1 m4) (not-later m2 m4)
    (not-later m3 m4) (not-later m4 m4) (not-later m0 m5) (not-later m1 m5) (not-later m2 m5)
    (not-later m3 m5) (not-later m4 m5) (not-later m5 m5) (not-later m0 m6) (not-later m1 m6)
    (not-later m2 m6) (not-later m3 m6) (not-later m4 m6) (not-later m5 m6) (not-later m6 m6)
    (not-later m0 m7) (not-later m1 m7) (not-later m2 m7) (not-later m3 m7) (not-later m4 m7)
    (not-later m5 m7) (not-later m6 m7) (not-later m7 m7) (at x0 p0) (at x1 p1) (at x2 p1))
  (:goal (and
    (delivered x0 p2 m7) (there x1 p0) (delivered x2 p2 m7))))

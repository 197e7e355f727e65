(define (problem psrlarge-middle) (:domain psr)
  (:objects
    cb0 cb1 cb2 sd0 sd1 sd2 sd3 sd4 sd5 sd6 sd7 sd8 sd9 sd10 - device l0 l1 l2 l3 l4 l5 l6 l7 l8 l9 l10 l11 - line)
  (:init
    (breaker cb0) (closed cb0) (ext l0 cb0 side2) (ext l0 sd0 side1) (ext l1 sd0 side2) (closed sd0)
    (ext l1 sd1 side1) (ext l2 sd1 side2) (closed sd1) (ext l2 sd2 side1) (ext l3 sd2 side2) (closed sd2)
    (breaker cb1) (closed cb1) (ext l4 cb1 side2) (ext l4 sd3 side1) (ext l5 sd3 side2) (closed sd3)
    (ext l5 sd4 side1) (ext l6 sd4 side2) (closed sd4) (ext l6 sd5 side1) (ext l7 sd5 side2) (closed sd5)
    (breaker cb2) (closed cb2) (ext l8 cb2 side2) (ext l8 sd6 side1) (ext l9 sd6 side2) (closed sd6)
    (ext l9 sd7 side1) (ext l10 sd7 side2) (closed sd7) (ext l10 sd8 side1) (ext l11 sd8 side2) (closed sd8)
    (ext l3 sd9 side1) (ext l7 sd9 side2) (ext l7 sd10 side1) (ext l11 sd10 side2) (faulty l1))
  (:goal (and
    (fed l0) (fed l2) (fed l3) (fed l4) (fed l5) (fed l6) (fed l7) (fed l8) (fed l9) (fed l10) (fed l11)
    (forall (?b - device) (not (affected ?b))))))

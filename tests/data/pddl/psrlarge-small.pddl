(define (problem psrlarge-small) (:domain psr)
  (:objects
    cb0 cb1 sd0 sd1 sd2 sd3 sd4 - device l0 l1 l2 l3 l4 l5 - line)
  (:init
    (breaker cb0) (closed cb0) (ext l0 cb0 side2) (ext l0 sd0 side1) (ext l1 sd0 side2) (closed sd0)
    (ext l1 sd1 side1) (ext l2 sd1 side2) (closed sd1) (breaker cb1) (closed cb1) (ext l3 cb1 side2)
    (ext l3 sd2 side1) (ext l4 sd2 side2) (closed sd2) (ext l4 sd3 side1) (ext l5 sd3 side2) (closed sd3)
    (ext l2 sd4 side1) (ext l5 sd4 side2) (faulty l2))
  (:goal (and
    (fed l0) (fed l1) (fed l3) (fed l4) (fed l5) (forall (?b - device) (not (affected ?b))))))

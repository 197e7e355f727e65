(define (problem psr-small) (:domain psr)
  (:objects cb0 cb1 sd0-0 sd0-1 sd0-2 sd1-0 sd1-1 sd1-2 - device l0-0 l0-1 l0-2 l1-0 l1-1 l1-2 lx0 - line)
  (:init
    (opposite side1 side2) (opposite side2 side1) (breaker cb0) (closed cb0) (ext l0-0 cb0 side2)
    (ext l0-0 sd0-0 side1) (closed sd0-0) (ext l0-1 sd0-0 side2) (ext l0-1 sd0-1 side1) (closed sd0-1)
    (ext l0-2 sd0-1 side2) (ext l0-2 sd0-2 side1) (breaker cb1) (closed cb1) (ext l1-0 cb1 side2)
    (ext l1-0 sd1-0 side1) (closed sd1-0) (ext l1-1 sd1-0 side2) (ext l1-1 sd1-1 side1) (closed sd1-1)
    (ext l1-2 sd1-1 side2) (ext l1-2 sd1-2 side1) (ext lx0 sd0-2 side2) (ext lx0 sd1-2 side2) (faulty l0-1))
  (:goal (and
    (not (affected cb0)) (not (affected cb1)) (fed l0-0) (fed l0-2) (fed l1-0) (fed l1-1) (fed l1-2))))

(define (problem openstacks-small) (:domain openstacks)
  (:objects n0 n1 n2 n3 n4 - count o0 o1 o2 o3 - order p0 p1 p2 p3 - product)
  (:init
    (next-count n0 n1) (next-count n1 n2) (next-count n2 n3) (next-count n3 n4) (stacks-avail n0) (waiting o0)
    (includes o0 p0) (includes o0 p3) (waiting o1) (includes o1 p3) (includes o1 p2) (includes o1 p1)
    (waiting o2) (includes o2 p0) (includes o2 p1) (includes o2 p3) (includes o2 p2) (waiting o3)
    (includes o3 p1) (includes o3 p0) (= (total-cost) 0))
  (:goal (and
    (shipped o0) (shipped o1) (shipped o2) (shipped o3)))
  (:metric minimize (total-cost)))

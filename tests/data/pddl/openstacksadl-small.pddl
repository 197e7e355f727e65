(define (problem openstacksadl-small) (:domain openstacks-sequencedstrips-ADL)
  (:objects
    n0 n1 n2 n3 n4 n5 - count o0 o1 o2 o3 o4 - order p0 p1 p2 p3 p4 - product)
  (:init
    (= (total-cost) 0) (stacks-avail n0) (next-count n0 n1) (next-count n1 n2) (next-count n2 n3) (next-count n3 n4)
    (next-count n4 n5) (waiting o0) (includes o0 p4) (waiting o1) (includes o1 p2) (waiting o2) (includes o2 p3)
    (waiting o3) (includes o3 p3) (includes o3 p4) (waiting o4) (includes o4 p0))
  (:goal (and
    (shipped o0) (made p0) (shipped o1) (made p1) (shipped o2) (made p2) (shipped o3) (made p3) (shipped o4)
    (made p4)))
  (:metric minimize (total-cost)))

(define (problem spanner-middle) (:domain spanner)
  (:objects
    bob - man shed gate l1 l2 l3 l4 l5 l6 l7 l8 - location s0 s1 s2 s3 s4 s5 s6 s7 - spanner n0 n1 n2 n3 n4
    n5 n6 n7 - nut)
  (:init
    (at bob shed) (link shed l1) (link l1 l2) (link l2 l3) (link l3 l4) (link l4 l5) (link l5 l6)
    (link l6 l7) (link l7 l8) (link l8 gate) (at s0 l3) (usable s0) (at s1 l2) (usable s1) (at s2 l5)
    (usable s2) (at s3 l2) (usable s3) (at s4 l8) (usable s4) (at s5 l8) (usable s5) (at s6 l8) (usable s6)
    (at s7 l7) (usable s7) (at n0 gate) (loose n0) (at n1 gate) (loose n1) (at n2 gate) (loose n2)
    (at n3 gate) (loose n3) (at n4 gate) (loose n4) (at n5 gate) (loose n5) (at n6 gate) (loose n6)
    (at n7 gate) (loose n7))
  (:goal (and
    (tight n0) (tight n1) (tight n2) (tight n3) (tight n4) (tight n5) (tight n6) (tight n7))))

(define (problem spanner-small) (:domain spanner)
  (:objects
    bob - man shed gate l1 l2 l3 l4 - location s0 s1 s2 s3 - spanner n0 n1 n2 n3 - nut)
  (:init
    (at bob shed) (link shed l1) (link l1 l2) (link l2 l3) (link l3 l4) (link l4 gate) (at s0 l2)
    (usable s0) (at s1 l1) (usable s1) (at s2 l3) (usable s2) (at s3 l1) (usable s3) (at n0 gate) (loose n0)
    (at n1 gate) (loose n1) (at n2 gate) (loose n2) (at n3 gate) (loose n3))
  (:goal (and
    (tight n0) (tight n1) (tight n2) (tight n3))))

(define (problem pathways-small) (:domain pathways)
  (:objects
    s0 s1 s2 s3 s4 s5 s6 s7 s8 s9 - simple k0 k1 k2 k3 k4 k5 k6 k7 k8 k9 k10 k11 k12 k13 k14 k15 k16 k17 k18 k19 -
    complex v0 v1 v2 v3 v4 v5 v6 v7 v8 - level)
  (:init
    (possible s0) (possible s1) (possible s2) (possible s3) (possible s4) (possible s5) (possible s6) (possible s7)
    (possible s8) (possible s9) (association-reaction s2 s1 k0) (synthesis-reaction k0 s7)
    (association-reaction s7 s6 k1) (synthesis-reaction k1 s0) (catalyzed-association-reaction s6 k1 k2)
    (association-reaction s0 k1 k3) (synthesis-reaction k3 s3) (association-reaction s9 s1 k4)
    (synthesis-reaction k4 s0) (association-reaction k0 s8 k5) (association-reaction k2 k0 k6)
    (association-reaction s0 s7 k7) (association-reaction k7 s7 k8) (synthesis-reaction k8 s3)
    (association-reaction k4 s9 k9) (association-reaction k7 s3 k10) (catalyzed-association-reaction s9 s3 k11)
    (catalyzed-association-reaction k6 k3 k12) (association-reaction k11 s6 k13) (synthesis-reaction k13 s7)
    (catalyzed-association-reaction k6 k2 k14) (catalyzed-association-reaction k5 s7 k15)
    (association-reaction k3 k11 k16) (catalyzed-association-reaction k12 k14 k17)
    (catalyzed-association-reaction s2 k4 k18) (catalyzed-association-reaction k14 s5 k19) (num-subs v8) (next v0 v1)
    (next v1 v2) (next v2 v3) (next v3 v4) (next v4 v5) (next v5 v6) (next v6 v7) (next v7 v8))
  (:goal (and
    (or (available k14) (available k15)) (or (available k16) (available k17)) (or (available k18) (available k19)))))

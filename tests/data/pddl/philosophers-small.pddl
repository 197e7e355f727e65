(define (problem philosophers-small) (:domain protocol)
  (:objects
    p0 p1 p2 - process phil - proctype s0 s1 s2 s3 s4 - state q0 q1 q2 - queue fork - message t0 t1 t2 t3 t4 -
    transition zero one - number)
  (:init
    (is-zero zero) (inc zero one) (is-a-process p0 phil) (at-process p0 s0) (queue-size q0 zero) (is-max q0 one)
    (writes p0 q0 t0) (reads p0 q0 t1) (reads p0 q1 t2) (writes p0 q0 t3) (writes p0 q1 t4) (is-a-process p1 phil)
    (at-process p1 s0) (queue-size q1 zero) (is-max q1 one) (writes p1 q1 t0) (reads p1 q1 t1) (reads p1 q2 t2)
    (writes p1 q1 t3) (writes p1 q2 t4) (is-a-process p2 phil) (at-process p2 s0) (queue-size q2 zero)
    (is-max q2 one) (writes p2 q2 t0) (reads p2 q2 t1) (reads p2 q0 t2) (writes p2 q2 t3) (writes p2 q0 t4)
    (trans phil t0 s0 s1) (trans-msg t0 fork) (trans phil t1 s1 s2) (trans-msg t1 fork) (trans phil t2 s2 s3)
    (trans-msg t2 fork) (trans phil t3 s3 s4) (trans-msg t3 fork) (trans phil t4 s4 s1) (trans-msg t4 fork))
  (:goal (and
    (blocked p0) (blocked p1) (blocked p2))))

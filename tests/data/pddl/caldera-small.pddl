(define (problem caldera-small) (:domain caldera)
  (:objects
    m0 m1 m2 - machine a0 a1 - account g0 - domain-group s0 s1 - share rat - tool)
  (:init
    (foothold m0) (knows-machine m0) (weak m0) (lies rat m0) (group m0 g0) (group m1 g0) (group m2 g0)
    (neighbour m0 m1) (admin a0 m1) (cached a0 m0) (has-share m1 s0) (neighbour m1 m2) (admin a1 m2)
    (cached a1 m1) (has-share m2 s1) (cached a1 m0))
  (:goal (and
    (stolen s0) (stolen s1) (clean m0) (clean m1) (clean m2))))

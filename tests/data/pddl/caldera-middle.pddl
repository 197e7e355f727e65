(define (problem caldera-middle) (:domain caldera)
  (:objects
    m0 m1 m2 m3 m4 m5 - machine a0 a1 a2 a3 a4 - account g0 - domain-group s0 s1 s2 s3 s4 - share rat - tool)
  (:init
    (foothold m0) (knows-machine m0) (weak m0) (lies rat m0) (group m0 g0) (group m1 g0) (group m2 g0)
    (group m3 g0) (group m4 g0) (group m5 g0) (neighbour m0 m1) (admin a0 m1) (cached a0 m0)
    (has-share m1 s0) (neighbour m1 m2) (admin a1 m2) (cached a1 m1) (has-share m2 s1) (neighbour m2 m3)
    (admin a2 m3) (cached a2 m2) (has-share m3 s2) (neighbour m3 m4) (admin a3 m4) (cached a3 m3)
    (has-share m4 s3) (cached a3 m0) (neighbour m4 m5) (admin a4 m5) (cached a4 m4) (has-share m5 s4)
    (cached a4 m0))
  (:goal (and
    (stolen s0) (stolen s1) (stolen s2) (stolen s3) (stolen s4) (clean m0) (clean m1) (clean m2) (clean m3)
    (clean m4) (clean m5))))

(define (problem driverlog-small) (:domain driverlog)
  (:objects driver0 driver1 - driver truck0 truck1 - truck package0 package1 package2 - obj s0 s1 s2 s3 p1 p2 p3 - location)
  (:init
    (link s1 s0) (link s0 s1) (link s2 s1) (link s1 s2) (link s3 s1) (link s1 s3) (link s3 s2) (link s2 s3)
    (path s1 p1) (path p1 s1) (path p1 s0) (path s0 p1) (path s2 p2) (path p2 s2) (path p2 s1) (path s1 p2)
    (path s3 p3) (path p3 s3) (path p3 s1) (path s1 p3) (at driver0 s0) (at driver1 s1) (at truck0 s2)
    (empty truck0) (at truck1 s1) (empty truck1) (at package0 s0) (at package1 s2) (at package2 s2))
  (:goal (and
    (at package0 s0) (at package1 s3) (at package2 s1) (at driver0 s3) (at driver1 s2) (at truck0 s3))))

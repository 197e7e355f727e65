(define (problem miconic-small) (:domain miconic)
  (:objects f0 f1 f2 f3 - floor p0 - passenger p1 - passenger p2 - vip p3 - attendant)
  (:init
    (lift-at f0) (above f0 f1) (above f0 f2) (above f0 f3) (above f1 f2) (above f1 f3) (above f2 f3)
    (origin p0 f3) (destin p0 f1) (no-access p0 f0) (origin p1 f3) (destin p1 f0) (origin p2 f2) (destin p2 f3)
    (no-access p2 f0) (origin p3 f2) (destin p3 f0))
  (:goal (and
    (forall (?p - passenger) (served ?p)))))

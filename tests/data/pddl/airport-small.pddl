(define (problem airport-small) (:domain airport-ground)
  (:init (at-park-p1) (at-hold-p2) (engine-on-p2) (free-taxi1) (free-taxi2) (free-junction) (free-runway))
  (:goal (and (airborne-p1) (airborne-p2))))

(define (problem ged-small) (:domain genome-edit-distance)
  (:objects
    g0 g1 g2 g3 g4 g5)
  (:init
    (idle) (= (total-cost) 0) (cw g0 g3) (present g0) (cw g3 g4) (present g1) (cw g4 g5) (present g2) (cw g5 g1)
    (present g3) (cw g1 g2) (present g4) (cw g2 g0) (present g5) (normal g0) (normal g1) (normal g2) (inverted g3)
    (normal g4) (inverted g5))
  (:goal (and
    (idle) (cw g0 g1) (normal g0) (cw g1 g2) (normal g1) (cw g2 g3) (normal g2) (cw g3 g4) (normal g3) (cw g4 g5)
    (normal g4) (cw g5 g0) (normal g5)))
  (:metric minimize (total-cost)))

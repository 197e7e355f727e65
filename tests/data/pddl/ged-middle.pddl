(define (problem ged-middle) (:domain genome-edit-distance)
  (:objects
    g0 g1 g2 g3 g4 g5 g6 g7 g8 g9)
  (:init
    (idle) (= (total-cost) 0) (cw g0 g4) (present g0) (cw g4 g7) (present g1) (cw g7 g5) (present g2) (cw g5 g6)
    (present g3) (cw g6 g8) (present g4) (cw g8 g3) (present g5) (cw g3 g9) (present g6) (cw g9 g2) (present g7)
    (cw g2 g1) (present g8) (cw g1 g0) (present g9) (inverted g0) (normal g1) (inverted g2) (normal g3) (normal g4)
    (normal g5) (normal g6) (normal g7) (normal g8) (inverted g9))
  (:goal (and
    (idle) (cw g0 g1) (normal g0) (cw g1 g2) (normal g1) (cw g2 g3) (normal g2) (cw g3 g4) (normal g3) (cw g4 g5)
    (normal g4) (cw g5 g6) (normal g5) (cw g6 g7) (normal g6) (cw g7 g8) (normal g7) (cw g8 g9) (normal g8)
    (cw g9 g0) (normal g9)))
  (:metric minimize (total-cost)))

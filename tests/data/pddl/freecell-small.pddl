(define (problem freecell-small) (:domain freecell)
  (:objects c1 c2 c3 c4 d1 d2 d3 d4 c0 d0 - card n0 n1 n2 n3 n4 - num clubs diamonds - suit)
  (:init
    (successor n1 n0) (successor n2 n1) (successor n3 n2) (successor n4 n3) (value c0 n0) (suit c0 clubs)
    (value c1 n1) (suit c1 clubs) (value c2 n2) (suit c2 clubs) (value c3 n3) (suit c3 clubs) (value c4 n4)
    (suit c4 clubs) (home c0) (value d0 n0) (suit d0 diamonds) (value d1 n1) (suit d1 diamonds) (value d2 n2)
    (suit d2 diamonds) (value d3 n3) (suit d3 diamonds) (value d4 n4) (suit d4 diamonds) (home d0)
    (canstack c1 d2) (canstack c2 d3) (canstack c3 d4) (canstack d1 c2) (canstack d2 c3) (canstack d3 c4)
    (bottomcol d3) (on c1 d3) (clear c1) (bottomcol d4) (on c3 d4) (clear c3) (bottomcol d1) (on d2 d1)
    (clear d2) (bottomcol c2) (on c4 c2) (clear c4) (colspace n0) (cellspace n2))
  (:goal (and
    (home c4) (home d4))))

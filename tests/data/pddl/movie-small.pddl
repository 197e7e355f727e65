(define (problem movie-small) (:domain movie)
  (:objects c0 c1 c2 c3 c4 d0 d1 d2 d3 d4 z0 z1 z2 z3 z4)
  (:init
    (chips c0) (chips c1) (chips c2) (chips c3) (chips c4) (dip d0) (dip d1) (dip d2) (dip d3) (dip d4) (pop z0)
    (pop z1) (pop z2) (pop z3) (pop z4) (counter-at-other-than-two-hours))
  (:goal (and
    (movie-rewound) (counter-at-zero) (have-chips) (have-dip) (have-pop))))

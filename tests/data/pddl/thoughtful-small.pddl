(define (problem thoughtful-small) (:domain thoughtful)
  (:objects
    heart4 spade3 heart2 spade2 spade4 heart1 spade1 heart3 back - card heart spade - suit n0 n1 n2 n3 n4 n5
    - rank)
  (:init
    (next n0 n1) (next n1 n2) (next n2 n3) (next n3 n4) (next n4 n5) (home-top heart n0) (home-top spade n0)
    (places n0) (suit-of heart4 heart) (rank-of heart4 n4) (king heart4) (suit-of spade3 spade)
    (rank-of spade3 n3) (can-stack spade3 heart4) (suit-of heart2 heart) (rank-of heart2 n2)
    (can-stack heart2 spade3) (suit-of spade2 spade) (rank-of spade2 n2) (can-stack spade2 heart3)
    (suit-of spade4 spade) (rank-of spade4 n4) (king spade4) (suit-of heart1 heart) (rank-of heart1 n1)
    (can-stack heart1 spade2) (suit-of spade1 spade) (rank-of spade1 n1) (can-stack spade1 heart2)
    (suit-of heart3 heart) (rank-of heart3 n3) (can-stack heart3 spade4) (bottom heart4) (clear heart4)
    (up heart4) (bottom spade3) (on heart2 spade3) (clear heart2) (up heart2) (bottom spade2)
    (on spade4 spade2) (on heart1 spade4) (clear heart1) (up heart1) (talon-next back spade1)
    (talon-next spade1 heart3) (talon-next heart3 back) (shown back))
  (:goal (and
    (home heart4) (home spade3) (home heart2) (home spade2) (home spade4) (home heart1) (home spade1)
    (home heart3))))

(define (problem labyrinth-small) (:domain labyrinth)
  (:objects
    c0_0 c0_1 c0_2 c1_0 c1_1 c1_2 c2_0 c2_1 c2_2 - card p0 p1 p2 - pos)
  (:init
    (= (total-cost) 0) (min-pos p0) (max-pos p2) (robot-at c0_0) (next p0 p1) (next p1 p2)
    (card-at c0_0 p0 p0) (be c0_0) (bw c0_0) (card-at c0_1 p0 p1) (bn c0_1) (be c0_1) (card-at c0_2 p0 p2)
    (be c0_2) (bw c0_2) (card-at c1_0 p1 p0) (bn c1_0) (be c1_0) (card-at c1_1 p1 p1) (bs c1_1) (bw c1_1)
    (card-at c1_2 p1 p2) (bn c1_2) (bw c1_2) (card-at c2_0 p2 p0) (bs c2_0) (card-at c2_1 p2 p1) (be c2_1)
    (bw c2_1) (card-at c2_2 p2 p2) (bn c2_2) (bs c2_2))
  (:goal (and
    (out)))
  (:metric minimize (total-cost)))

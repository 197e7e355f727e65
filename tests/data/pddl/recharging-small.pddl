(define (problem p) (:domain recharging)
 (:objects l0 l1 l2 l3 l4 l5 - location r0 r1 - robot b0 b1 b2 b3 b4 - level c0 - config)
 (:init (connected l0 l1) (connected l0 l2) (connected l0 l4) (connected l1 l3) (connected l3 l4) (connected l3 l5) (connected l4 l5) (next b0 b1) (next b1 b2) (next b2 b3) (next b3 b4) (at r0 l0) (battery r0 b3) (at r1 l0) (battery r1 b3) (wanted c0 l3) (wanted c0 l4) (= (total-cost) 0) (= (move-cost) 1) (= (recharge-cost) 0))
 (:goal (and (fulfilled c0))) (:metric minimize (total-cost)))

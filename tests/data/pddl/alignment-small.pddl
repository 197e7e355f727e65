(define (problem p) (:domain alignment)
 (:init (p0) (e0) (= (total-cost) 0))
 (:goal (and (e56) (p7) (p22) (p46) (p48) (p59))) (:metric minimize (total-cost)))

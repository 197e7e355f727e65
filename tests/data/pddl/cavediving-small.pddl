(define (problem cavediving-small) (:domain cave-diving-adl)
  (:objects
    l0 l1 - location d0 d1 - diver t0 t1 t2 t3 t4 t5 t6 - tank zero one two three four - quantity)
  (:init
    (= (total-cost) 0) (= (other-cost) 1) (cave-entrance l0) (connected l0 l1) (connected l1 l0) (available d0)
    (capacity d0 four) (= (hiring-cost d0) 27) (available d1) (capacity d1 four) (= (hiring-cost d1) 82)
    (in-storage t0) (next-tank t0 t1) (next-tank t1 t2) (next-tank t2 t3) (next-tank t3 t4) (next-tank t4 t5)
    (next-tank t5 t6) (next-quantity zero one) (next-quantity one two) (next-quantity two three)
    (next-quantity three four))
  (:goal (and
    (have-photo l1) (decompressing d0)))
  (:metric minimize (total-cost)))

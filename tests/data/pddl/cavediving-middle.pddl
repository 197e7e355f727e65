(define (problem cavediving-middle) (:domain cave-diving-adl)
  (:objects
    l0 l1 l2 l3 - location d0 d1 d2 - diver t0 t1 t2 t3 t4 t5 t6 t7 t8 t9 t10 t11 t12 t13 t14 t15 t16 - tank zero one
    two three four - quantity)
  (:init
    (= (total-cost) 0) (= (other-cost) 1) (cave-entrance l0) (connected l0 l1) (connected l1 l0) (connected l1 l2)
    (connected l2 l1) (connected l2 l3) (connected l3 l2) (available d0) (capacity d0 four) (= (hiring-cost d0) 40)
    (available d1) (capacity d1 four) (= (hiring-cost d1) 85) (available d2) (capacity d2 four)
    (= (hiring-cost d2) 79) (in-storage t0) (next-tank t0 t1) (next-tank t1 t2) (next-tank t2 t3) (next-tank t3 t4)
    (next-tank t4 t5) (next-tank t5 t6) (next-tank t6 t7) (next-tank t7 t8) (next-tank t8 t9) (next-tank t9 t10)
    (next-tank t10 t11) (next-tank t11 t12) (next-tank t12 t13) (next-tank t13 t14) (next-tank t14 t15)
    (next-tank t15 t16) (next-quantity zero one) (next-quantity one two) (next-quantity two three)
    (next-quantity three four) (precludes d0 d1))
  (:goal (and
    (have-photo l3) (decompressing d0)))
  (:metric minimize (total-cost)))

(define (problem trucks-small) (:domain trucks)
  (:objects truck0 - truck package0 package1 - package l0 l1 l2 - location t0 t1 t2 t3 t4 t5 - time a1 a2 - truckarea)
  (:init
    (time-now t0) (connected l0 l1) (connected l0 l2) (connected l1 l0) (connected l1 l2) (connected l2 l0)
    (connected l2 l1) (next t0 t1) (next t1 t2) (next t2 t3) (next t3 t4) (next t4 t5) (le t1 t1) (le t1 t2)
    (le t1 t3) (le t1 t4) (le t1 t5) (le t2 t2) (le t2 t3) (le t2 t4) (le t2 t5) (le t3 t3) (le t3 t4)
    (le t3 t5) (le t4 t4) (le t4 t5) (le t5 t5) (at truck0 l0) (free a1 truck0) (free a2 truck0) (closer a1 a2)
    (at package0 l1) (at package1 l0))
  (:goal (and
    (at-destination package0 l0) (delivered package1 l1 t5))))

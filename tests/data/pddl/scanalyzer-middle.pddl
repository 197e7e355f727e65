(define (problem scanalyzer-middle) (:domain scanalyzer3d)
  (:objects
    seg-in-0 seg-in-1 seg-in-2 seg-in-3 seg-out-0 seg-out-1 seg-out-2 seg-out-3 - segment car-in-0 car-in-1 car-in-2
    car-in-3 car-out-0 car-out-1 car-out-2 car-out-3 - car)
  (:init
    (= (total-cost) 0) (CYCLE-2 seg-in-0 seg-out-0) (CYCLE-2 seg-in-0 seg-out-1) (CYCLE-2 seg-in-0 seg-out-2)
    (CYCLE-2 seg-in-0 seg-out-3) (CYCLE-2 seg-in-1 seg-out-0) (CYCLE-2 seg-in-1 seg-out-1)
    (CYCLE-2 seg-in-1 seg-out-2) (CYCLE-2 seg-in-1 seg-out-3) (CYCLE-2 seg-in-2 seg-out-0)
    (CYCLE-2 seg-in-2 seg-out-1) (CYCLE-2 seg-in-2 seg-out-2) (CYCLE-2 seg-in-2 seg-out-3)
    (CYCLE-2 seg-in-3 seg-out-0) (CYCLE-2 seg-in-3 seg-out-1) (CYCLE-2 seg-in-3 seg-out-2)
    (CYCLE-2 seg-in-3 seg-out-3) (CYCLE-2-WITH-ANALYSIS seg-in-0 seg-out-3) (on car-in-0 seg-in-0)
    (on car-in-1 seg-in-1) (on car-in-2 seg-in-2) (on car-in-3 seg-in-3) (on car-out-0 seg-out-0)
    (on car-out-1 seg-out-1) (on car-out-2 seg-out-2) (on car-out-3 seg-out-3))
  (:goal (and
    (on car-in-0 seg-out-1) (analyzed car-in-0) (on car-in-1 seg-in-3) (analyzed car-in-1) (on car-in-2 seg-out-0)
    (analyzed car-in-2) (on car-in-3 seg-in-1) (analyzed car-in-3) (on car-out-0 seg-in-2) (analyzed car-out-0)
    (on car-out-1 seg-out-2) (analyzed car-out-1) (on car-out-2 seg-out-3) (analyzed car-out-2)
    (on car-out-3 seg-in-0) (analyzed car-out-3)))
  (:metric minimize (total-cost)))

(define (problem scanalyzer-small) (:domain scanalyzer3d)
  (:objects
    seg-in-0 seg-in-1 seg-out-0 seg-out-1 - segment car-in-0 car-in-1 car-out-0 car-out-1 - car)
  (:init
    (= (total-cost) 0) (CYCLE-2 seg-in-0 seg-out-0) (CYCLE-2 seg-in-0 seg-out-1) (CYCLE-2 seg-in-1 seg-out-0)
    (CYCLE-2 seg-in-1 seg-out-1) (CYCLE-2-WITH-ANALYSIS seg-in-0 seg-out-1) (on car-in-0 seg-in-0)
    (on car-in-1 seg-in-1) (on car-out-0 seg-out-0) (on car-out-1 seg-out-1))
  (:goal (and
    (on car-in-0 seg-out-1) (analyzed car-in-0) (on car-in-1 seg-in-0) (analyzed car-in-1) (on car-out-0 seg-out-0)
    (analyzed car-out-0) (on car-out-1 seg-in-1) (analyzed car-out-1)))
  (:metric minimize (total-cost)))

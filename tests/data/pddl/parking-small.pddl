(define (problem parking-small) (:domain parking)
  (:objects car0 car1 car2 car3 - car curb0 curb1 curb2 - curb)
  (:init
    (= (total-cost) 0) (at-curb car2) (at-curb-num car2 curb0) (behind-car car3 car2) (car-clear car3)
    (at-curb car0) (at-curb-num car0 curb1) (behind-car car1 car0) (car-clear car1) (curb-clear curb2))
  (:goal (and
    (at-curb-num car2 curb0) (at-curb-num car1 curb1) (at-curb-num car0 curb2) (behind-car car3 car2)))
  (:metric minimize (total-cost)))

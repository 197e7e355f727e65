(define (problem parking-middle) (:domain parking)
  (:objects car0 car1 car2 car3 car4 car5 car6 car7 car8 car9 car10 car11 - car curb0 curb1 curb2 curb3 curb4 curb5 curb6 - curb)
  (:init
    (= (total-cost) 0) (at-curb car2) (at-curb-num car2 curb0) (behind-car car7 car2) (car-clear car7)
    (at-curb car6) (at-curb-num car6 curb1) (behind-car car5 car6) (car-clear car5) (at-curb car0)
    (at-curb-num car0 curb2) (behind-car car1 car0) (car-clear car1) (at-curb car4) (at-curb-num car4 curb3)
    (behind-car car3 car4) (car-clear car3) (at-curb car10) (at-curb-num car10 curb4) (behind-car car11 car10)
    (car-clear car11) (at-curb car8) (at-curb-num car8 curb5) (behind-car car9 car8) (car-clear car9)
    (curb-clear curb6))
  (:goal (and
    (at-curb-num car10 curb0) (at-curb-num car1 curb1) (at-curb-num car0 curb2) (at-curb-num car11 curb3)
    (at-curb-num car6 curb4) (at-curb-num car7 curb5) (at-curb-num car5 curb6) (behind-car car4 car10)
    (behind-car car9 car1) (behind-car car3 car0) (behind-car car2 car11) (behind-car car8 car6)))
  (:metric minimize (total-cost)))

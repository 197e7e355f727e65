(define (problem zenotravel-middle) (:domain zenotravel)
  (:objects plane0 plane1 plane2 - aircraft person0 person1 person2 person3 person4 person5 person6 person7 person8 person9 - person city0 city1 city2 city3 city4 city5 city6 city7 - city fl0 fl1 fl2 fl3 fl4 fl5 fl6 - flevel)
  (:init
    (next fl0 fl1) (next fl1 fl2) (next fl2 fl3) (next fl3 fl4) (next fl4 fl5) (next fl5 fl6) (at plane0 city3)
    (fuel-level plane0 fl6) (at plane1 city1) (fuel-level plane1 fl0) (at plane2 city3) (fuel-level plane2 fl2)
    (at person0 city4) (at person1 city6) (at person2 city4) (at person3 city6) (at person4 city7)
    (at person5 city1) (at person6 city0) (at person7 city2) (at person8 city2) (at person9 city0))
  (:goal (and
    (at person0 city7) (at person1 city6) (at person2 city3) (at person3 city6) (at person4 city5)
    (at person5 city2) (at person6 city5) (at person7 city4) (at person8 city5) (at person9 city5)
    (at plane0 city4))))

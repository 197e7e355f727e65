(define (problem mystery-small) (:domain mystery-strips)
  (:objects
    food0 food1 food2 food3 food4 food5 prov0 prov1 prov2 prov3 prov4 prov5 prov6 plan0 plan1 plan2 v0 v1 c0 c1 c2 c3
    c4)
  (:init
    (food food0) (food food1) (food food2) (food food3) (food food4) (food food5) (province prov0) (province prov1)
    (province prov2) (province prov3) (province prov4) (province prov5) (province prov6) (planet plan0)
    (planet plan1) (planet plan2) (attacks prov0 prov1) (attacks prov1 prov2) (attacks prov2 prov3)
    (attacks prov3 prov4) (attacks prov4 prov5) (attacks prov5 prov6) (orbits plan0 plan1) (orbits plan1 plan2)
    (eats food4 food0) (eats food0 food4) (eats food3 food1) (eats food1 food3) (eats food5 food3) (eats food3 food5)
    (eats food2 food0) (eats food0 food2) (eats food1 food0) (eats food0 food1) (eats food3 food5) (eats food5 food3)
    (locale food0 prov6) (locale food1 prov3) (locale food2 prov6) (locale food3 prov6) (locale food4 prov3)
    (locale food5 prov6) (pleasure v0) (craves v0 food2) (harmony v0 plan1) (pleasure v1) (craves v1 food4)
    (harmony v1 plan1) (pain c0) (craves c0 food2) (pain c1) (craves c1 food0) (pain c2) (craves c2 food5) (pain c3)
    (craves c3 food0) (pain c4) (craves c4 food5))
  (:goal (and
    (craves c0 food0) (craves c1 food5) (craves c2 food4))))

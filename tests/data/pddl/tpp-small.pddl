(define (problem tpp-small) (:domain tpp)
  (:objects depot1 - depot market0 market1 - market truck0 - truck goods0 goods1 - goods level0 level1 level2 - level)
  (:init
    (next level1 level0) (next level2 level1) (connected market0 depot1) (connected depot1 market0)
    (connected market1 market0) (connected market0 market1) (on-sale goods0 market0 level1)
    (ready-to-load goods0 market0 level0) (on-sale goods0 market1 level1) (ready-to-load goods0 market1 level0)
    (stored goods0 level0) (loaded goods0 truck0 level0) (on-sale goods1 market0 level0)
    (ready-to-load goods1 market0 level0) (on-sale goods1 market1 level2) (ready-to-load goods1 market1 level0)
    (stored goods1 level0) (loaded goods1 truck0 level0) (at truck0 depot1))
  (:goal (and
    (stored goods0 level2) (stored goods1 level2))))

(define (problem agricola-small) (:domain agricola)
  (:objects
    w0 w1 end - worker r0 r1 r2 r3 - round mill fold pond plough seed cradle - spot f0 - field l0 l1 l2 l3 -
    level)
  (:init
    (= (total-cost) 0) (working) (now r0) (first w0) (last end) (next r0 r1) (next r1 r2) (next r2 r3)
    (follows w0 w1) (follows w1 end) (member w0) (idle w0) (member w1) (idle w1) (up l0 l1) (up l1 l2)
    (up l2 l3) (has grain l0) (has sheep l0) (has food l2) (wild f0) (open mill) (open fold) (open pond)
    (open plough) (open seed) (open cradle) (gives mill grain) (gives fold sheep) (gives pond food)
    (plough-spot plough) (sow-spot seed) (grow-spot cradle))
  (:goal (and
    (sown f0) (now r2) (working))))

(define (problem agricola-middle) (:domain agricola)
  (:objects
    w0 w1 w2 end - worker r0 r1 r2 r3 r4 r5 r6 - round mill fold pond plough seed cradle - spot f0 f1 -
    field l0 l1 l2 l3 l4 l5 l6 l7 - level)
  (:init
    (= (total-cost) 0) (working) (now r0) (first w0) (last end) (next r0 r1) (next r1 r2) (next r2 r3)
    (next r3 r4) (next r4 r5) (next r5 r6) (follows w0 w1) (follows w1 w2) (follows w2 end) (member w0)
    (idle w0) (member w1) (idle w1) (unborn w2) (up l0 l1) (up l1 l2) (up l2 l3) (up l3 l4) (up l4 l5)
    (up l5 l6) (up l6 l7) (has grain l0) (has sheep l0) (has food l6) (wild f0) (wild f1) (open mill)
    (open fold) (open pond) (open plough) (open seed) (open cradle) (gives mill grain) (gives fold sheep)
    (gives pond food) (plough-spot plough) (sow-spot seed) (grow-spot cradle))
  (:goal (and
    (sown f0) (sown f1) (member w2) (has sheep l1) (working))))

(define (problem settlers-small) (:domain settlers)
  (:objects
    bay hill - place c0 c1 - cart s0 - ship l0 l1 l2 - level)
  (:init
    (= (total-cost) 0) (zero l0) (next l0 l1) (next l1 l2) (land bay hill) (land hill bay)
    (stock bay timber l0) (stock bay stone l0) (stock bay wood l0) (stock hill timber l0)
    (stock hill stone l0) (stock hill wood l0) (forest bay) (rock hill))
  (:goal (and
    (house bay)))
  (:metric minimize (total-cost)))

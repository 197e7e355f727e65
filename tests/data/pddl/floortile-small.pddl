(define (problem floortile-small) (:domain floor-tile)
  (:objects t0-0 t0-1 t1-0 t1-1 t2-0 t2-1 - tile robot0 - robot white black - color)
  (:init
    (= (total-cost) 0) (up t1-0 t0-0) (down t0-0 t1-0) (right t0-1 t0-0) (left t0-0 t0-1) (up t1-1 t0-1)
    (down t0-1 t1-1) (up t2-0 t1-0) (down t1-0 t2-0) (right t1-1 t1-0) (left t1-0 t1-1) (up t2-1 t1-1)
    (down t1-1 t2-1) (right t2-1 t2-0) (left t2-0 t2-1) (robot-at robot0 t0-0) (robot-has robot0 black)
    (clear t0-1) (clear t1-0) (clear t1-1) (clear t2-0) (clear t2-1) (available-color white)
    (available-color black))
  (:goal (and
    (painted t1-0 white) (painted t1-1 black) (painted t2-0 black) (painted t2-1 white)))
  (:metric minimize (total-cost)))

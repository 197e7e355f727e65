(define (problem pipesworld-small) (:domain pipesworld)
  (:objects s0 - pipe a0 a1 - area b0 b1 b2 b3 b4 - batch-atom)
  (:init
    (may-interface lco lco) (may-interface gasoleo gasoleo) (may-interface rat-a rat-a)
    (may-interface oca1 oca1) (may-interface oc1b oc1b) (may-interface lco gasoleo) (may-interface gasoleo lco)
    (may-interface lco rat-a) (may-interface rat-a lco) (may-interface gasoleo oca1)
    (may-interface oca1 gasoleo) (may-interface oca1 oc1b) (may-interface oc1b oca1)
    (may-interface gasoleo oc1b) (may-interface oc1b gasoleo) (connect a0 a1 s0) (normal s0) (is-product b0 lco)
    (unitary s0) (first b0 s0) (last b0 s0) (is-product b1 gasoleo) (on b1 a0) (is-product b2 gasoleo)
    (on b2 a1) (is-product b3 lco) (on b3 a1) (is-product b4 lco) (on b4 a0))
  (:goal (and
    (on b1 a1))))

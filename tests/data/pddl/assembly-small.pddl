(define (problem p) (:domain assembly) (:objects top a1 a2 a3 a4 a5 a6 t7 - assembly r0 r1 - resource)
 (:init (part-of a1 top) (part-of a2 top) (part-of a3 a1) (part-of a4 a1) (available a3) (available a4) (part-of a5 a2) (part-of a6 a2) (available a5) (available a6) (requires top r0) (assemble-order a1 a2 top) (available t7) (transient-part t7 top) (assemble-order t7 a2 top) (remove-order a2 t7 top) (free r0) (free r1))
 (:goal (complete top)))

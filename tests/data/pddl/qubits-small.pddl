(define (problem p) (:domain qubits)
 (:objects p0-0 p0-1 p1-0 p1-1 - place q0 q1 q2 q3 - qubit g0 g1 g2 g3 g4 end - gate)
 (:init (gate g0 q1 q2) (ready g0 q1) (ready g0 q2) (gate g1 q0 q1) (ready g1 q0) (follows g1 g0 q1) (gate g2 q0 q1) (follows g2 g1 q0) (follows g2 g1 q1) (gate g3 q3 q1) (ready g3 q3) (follows g3 g2 q1) (gate g4 q3 q0) (follows g4 g3 q3) (follows g4 g2 q0) (follows end g3 q1) (follows end g0 q2) (follows end g4 q0) (follows end g4 q3) (joined p0-0 p0-1) (joined p0-0 p1-0) (joined p0-1 p1-1) (joined p0-1 p0-0) (joined p1-0 p1-1) (joined p1-0 p0-0) (joined p1-1 p1-0) (joined p1-1 p0-1) (= (total-cost) 0))
 (:goal (and (done g0) (done g1) (done g2) (done g3) (done g4))) (:metric minimize (total-cost)))

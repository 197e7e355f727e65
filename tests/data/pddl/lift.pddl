; A lift with house rules: nobody who needs company rides without it, guests of honour are not carried past their
; floor, some floors are closed to some people. Everything that ADL offers.
(define (domain lift)
  (:requirements :adl)
  (:types passenger floor - object
          honoured companion needs-company - passenger)
  (:predicates (origin ?p - passenger ?f - floor) (wants ?p - passenger ?f - floor) (banned ?p - passenger ?f - floor)
               (boarded ?p - passenger) (served ?p - passenger) (lift-at ?f - floor))
  (:action stop :parameters (?f - floor)
    :precondition (and
      (lift-at ?f)
      (forall (?p - passenger) (imply (banned ?p ?f) (not (boarded ?p))))
      (imply (exists (?p - honoured) (and (boarded ?p) (not (served ?p))))
             (exists (?q - honoured) (and (boarded ?q) (wants ?q ?f))))
      (forall (?n - needs-company)
        (imply (or (and (origin ?n ?f) (not (served ?n))) (and (boarded ?n) (not (wants ?n ?f))))
               (exists (?c - companion)
                 (or (and (boarded ?c) (not (wants ?c ?f))) (and (origin ?c ?f) (not (served ?c))))))))
    :effect (and
      (forall (?p - passenger) (when (and (boarded ?p) (wants ?p ?f)) (and (not (boarded ?p)) (served ?p))))
      (forall (?p - passenger) (when (and (origin ?p ?f) (not (served ?p))) (boarded ?p)))))
  (:action ride :parameters (?from ?to - floor)
    :precondition (and (lift-at ?from) (not (= ?from ?to)))
    :effect (and (lift-at ?to) (not (lift-at ?from)))))

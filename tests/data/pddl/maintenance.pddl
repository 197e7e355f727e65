; Planes are seen to on the days they pass an airport (ADL).
(define (domain maintenance-scheduling-domain)
  (:requirements :adl :typing)
  (:types plane day airport)
  (:predicates (done ?p - plane) (today ?d - day) (at ?p - plane ?d - day ?c - airport) (next ?d1 ?d2 - day))
  (:action workat :parameters (?day - day ?airport - airport)
    :precondition (today ?day)
    :effect (and (not (today ?day)) (forall (?plane - plane) (when (at ?plane ?day ?airport) (done ?plane))) (forall
      (?d2 - day) (when (next ?day ?d2) (today ?d2))))))

; Sliding tiles.
(define (domain n-puzzle)
  (:requirements :typing)
  (:types position tile)
  (:predicates (at ?t - tile ?p - position) (empty ?p - position) (neighbor ?a ?b - position))
  (:action move :parameters (?t - tile ?from ?to - position)
    :precondition (and (neighbor ?from ?to) (at ?t ?from) (empty ?to))
    :effect (and (at ?t ?to) (empty ?from) (not (at ?t ?from)) (not (empty ?to)))))

; One man walks one way past spanners that serve once each; every nut at the gate needs one.
(define (domain spanner) (:requirements :typing :strips)
 (:types location locatable - object man nut spanner - locatable)
 (:predicates (at ?m - locatable ?l - location) (carrying ?m - man ?s - spanner) (usable ?s - spanner) (link ?a ?b - location) (tight ?n - nut) (loose ?n - nut))
 (:action walk :parameters (?from ?to - location ?m - man) :precondition (and (at ?m ?from) (link ?from ?to)) :effect (and (not (at ?m ?from)) (at ?m ?to)))
 (:action pick :parameters (?l - location ?s - spanner ?m - man) :precondition (and (at ?m ?l) (at ?s ?l)) :effect (and (not (at ?s ?l)) (carrying ?m ?s)))
 (:action tighten :parameters (?l - location ?s - spanner ?m - man ?n - nut) :precondition (and (at ?m ?l) (at ?n ?l) (carrying ?m ?s) (usable ?s) (loose ?n)) :effect (and (not (loose ?n)) (not (usable ?s)) (tight ?n))))

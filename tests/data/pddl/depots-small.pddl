(define (problem depots-small) (:domain depots)
  (:objects depot0 - depot dist0 dist1 - distributor truck0 truck1 - truck pallet0 pallet1 pallet2 - pallet crate0 crate1 crate2 crate3 - crate hoist0 hoist1 hoist2 - hoist)
  (:init
    (at pallet0 depot0) (at pallet1 dist0) (at pallet2 dist1) (at hoist0 depot0) (available hoist0)
    (at hoist1 dist0) (available hoist1) (at hoist2 dist1) (available hoist2) (at truck0 dist0)
    (at truck1 dist0) (on crate0 pallet1) (at crate0 dist0) (on crate1 pallet0) (at crate1 depot0)
    (on crate2 crate1) (at crate2 depot0) (on crate3 crate0) (at crate3 dist0) (clear crate2) (clear crate3)
    (clear pallet2))
  (:goal (and
    (on crate1 pallet2) (on crate2 crate1) (on crate0 pallet0))))

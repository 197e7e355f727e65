(define (problem storage-small) (:domain storage)
  (:objects depot0 - depot container0 - container d0-0-0 d0-0-1 d0-1-0 d0-1-1 c0-0 c0-1 - storearea hoist0 - hoist crate0 crate1 - crate loadarea - transitarea)
  (:init
    (in d0-0-0 depot0) (in d0-0-1 depot0) (in d0-1-0 depot0) (in d0-1-1 depot0) (connected d0-0-0 d0-1-0)
    (connected d0-0-0 d0-0-1) (connected d0-0-1 d0-1-1) (connected d0-0-1 d0-0-0) (connected d0-1-0 d0-0-0)
    (connected d0-1-0 d0-1-1) (connected d0-1-1 d0-0-1) (connected d0-1-1 d0-1-0) (connected d0-0-0 loadarea)
    (connected loadarea d0-0-0) (at hoist0 d0-0-0) (available hoist0) (clear d0-0-1) (clear d0-1-0)
    (clear d0-1-1) (in c0-0 container0) (connected c0-0 loadarea) (connected loadarea c0-0) (on crate0 c0-0)
    (in crate0 container0) (in c0-1 container0) (connected c0-1 loadarea) (connected loadarea c0-1)
    (on crate1 c0-1) (in crate1 container0))
  (:goal (and
    (in crate0 depot0) (in crate1 depot0))))

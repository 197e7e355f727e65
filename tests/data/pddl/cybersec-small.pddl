(define (problem cybersec-small) (:domain cybersec)
  (:objects
    bob ann tim - person desk mail store vault - host hall office lab - room plans wages - file a-bob a-ann
    a-tim a-root - account ftpd - program key1 - key)
  (:init
    (= (total-cost) 0) (me bob) (in bob hall) (door hall office) (door office hall) (locked office lab)
    (opens key1 office lab) (lies key1 hall) (stands desk office) (stands vault lab) (wire desk mail)
    (wire mail store) (on a-bob desk) (on a-bob mail) (on a-ann mail) (on a-ann store) (on a-tim vault)
    (on a-root store) (owner a-bob bob) (owner a-ann ann) (owner a-tim tim) (knows bob a-bob)
    (runs store ftpd) (hole ftpd a-root) (holds store wages) (holds vault plans) (reader a-root wages)
    (reader a-tim plans) (trusts tim bob))
  (:goal (and
    (read bob plans) (read bob wages)))
  (:metric minimize (total-cost)))

(define (problem mprime-small) (:domain mprime)
  (:objects node0 node1 node2 node3 - node v0 v1 - conveyance cargo0 cargo1 - cargo fuel0 fuel1 fuel2 fuel3 fuel4 fuel5 fuel6 - fuel space0 space1 space2 space3 - space)
  (:init
    (fuel-neighbor fuel0 fuel1) (fuel-neighbor fuel1 fuel2) (fuel-neighbor fuel2 fuel3)
    (fuel-neighbor fuel3 fuel4) (fuel-neighbor fuel4 fuel5) (fuel-neighbor fuel5 fuel6)
    (space-neighbor space0 space1) (space-neighbor space1 space2) (space-neighbor space2 space3)
    (conn node1 node0) (conn node0 node1) (conn node2 node0) (conn node0 node2) (conn node3 node0)
    (conn node0 node3) (conn node3 node2) (conn node2 node3) (has-fuel node0 fuel5) (has-fuel node1 fuel2)
    (has-fuel node2 fuel5) (has-fuel node3 fuel5) (at v0 node0) (has-space v0 space3) (at v1 node3)
    (has-space v1 space3) (at cargo0 node1) (at cargo1 node0))
  (:goal (and
    (at cargo0 node0))))

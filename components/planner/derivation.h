// What follows from the axioms in a state: every condition counts down what it still waits for, so that a
// state costs as much as there is that holds, however much the axioms say besides. Internal to the planner.
#pragma once

#include <cstdint>
#include <vector>

namespace goalnet::planner {

struct GroundTask;

class Derivation {
 public:
  // For a task whose axioms, junctions and derived atoms are complete.
  void build(const GroundTask& task);
  void clear();

  // Sets the derived atoms as the rest of the state demands. Not from two threads at once.
  void run(std::uint64_t* state) const;

 private:
  // An axiom, or a junction that one of them asks for.
  struct Gate {
    std::int32_t waits_for = 0;  // inputs
    std::int32_t head = -1;      // the literal that follows; -1: another gate
  };
  struct Table {  // lists of gates, by number
    std::vector<std::uint32_t> begin;
    std::vector<std::int32_t> gates;
  };
  void signal(const Table& table, std::int32_t from, std::uint64_t* state) const;
  void open(std::int32_t gate, std::uint64_t* state) const;
  void propagate(std::uint64_t* state) const;

  std::vector<Gate> gates_;
  std::vector<std::int32_t> first_waits_;
  std::vector<std::int32_t> open_at_once_;
  Table of_literal_, of_gate_;                       // who waits for it
  std::vector<std::int32_t> given_;                  // literals of other atoms that gates wait for
  std::vector<std::int32_t> derived_;                // atoms
  std::vector<std::vector<std::int32_t>> negative_;  // by layer: negated derived atoms that gates wait for
  // While running:
  mutable std::vector<std::int32_t> waits_, fresh_;
};

}  // namespace goalnet::planner

// Finds some plan quickly where an optimal one is out of reach: lazy greedy best-first search with the relaxed-plan
// heuristic and preferred actions (Helmert's Fast Downward, JAIR 2006, two queues with boosting).
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/plan.h"
#include "components/planner/relaxed_plan.h"
#include "components/planner/state_table.h"

namespace goalnet::planner {

class GreedySearch {
 public:
  enum class Result { kFound, kExhausted, kStopped, kLimit };

  // `most_states`: evaluated before giving up with kLimit; `most_bytes` likewise (0 = no limit). Only plans cheaper than
  // `upper_bound` count.
  Result search(const GroundTask& task, RelaxedPlanner& heuristic, const Word* initial, std::int64_t upper_bound,
                std::int64_t most_states, std::int64_t most_bytes, Budget& budget, Statistics& statistics);
  const std::vector<std::int32_t>& plan() const { return plan_; }

 private:
  struct Node {
    std::int32_t parent = -1;
    std::int32_t action = -1;
    std::int64_t g = 0;
  };
  struct Entry {  // a successor not yet made
    std::int64_t h;       // of the parent
    std::int64_t serial;  // first in, first out
    std::int32_t parent;
    std::int32_t action;
    bool operator<(const Entry& other) const { return h != other.h ? h > other.h : serial > other.serial; }
  };
  struct Queue {
    std::vector<Entry> heap;
    std::int64_t priority = 0;
  };

  bool pop(Entry* entry);
  void push(Queue& queue, std::int64_t h, std::int32_t parent, std::int32_t action);

  StateTable states_;
  std::vector<Node> nodes_;
  Queue all_, preferred_;
  std::int64_t serial_ = 0;
  std::vector<Word> next_;
  std::vector<std::int32_t> plan_;
};

}  // namespace goalnet::planner

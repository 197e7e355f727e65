// A* with LM-cut, strong stubborn sets and symmetry breaking. Evaluation is lazy: a state enters the queue
// with what its parent's estimate implies and is evaluated when it comes up, which in easy problems is hardly
// ever.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/chunks.h"
#include "components/planner/lm_cut.h"
#include "components/planner/plan.h"
#include "components/planner/state_table.h"
#include "components/planner/stubborn_sets.h"
#include "components/planner/symmetry.h"

namespace goalnet::planner {

struct SearchLimits {
  std::int64_t nodes = 0;                    // expanded since start; 0 = no limit
  std::int64_t bytes = 0;                    // of tables; 0 = no limit
  std::int64_t upper_bound = INT64_MAX / 4;  // only plans cheaper than this are of interest
};

class OptimalSearch {
 public:
  enum class Result { kFound, kExhausted, kStopped, kNodeLimit, kMemoryLimit };

  // `initial_estimate` is LM-cut's value of the initial state. Task and heuristic must outlive the search.
  void start(const GroundTask& task, LmCut& lm_cut, const Word* initial, std::int64_t initial_estimate,
             Budget& budget);

  // Searches on from where it stopped. kFound: plan() is a cheapest plan below the upper bound. kExhausted:
  // there is none below it. The upper bound may only go down from call to call.
  Result resume(const SearchLimits& limits, Budget& budget, Statistics& statistics);

  const std::vector<std::int32_t>& plan() const { return plan_; }
  // Whether some state was left aside because of the upper bound: then kExhausted holds only below it.
  bool bound_used() const { return bound_used_; }
  std::int64_t expanded() const { return expanded_; }
  // No plan is cheaper than this; grows while searching.
  std::int64_t lower_bound() const { return lower_bound_; }

 private:
  struct Node {
    std::int64_t g = 0;
    std::int64_t h = 0;
    std::int32_t parent = -1;
    std::int32_t action = -1;
    bool evaluated = false;
    bool closed = false;
  };
  struct Entry {
    std::int32_t node;
    std::int64_t g;
  };
  void push(std::int32_t node);
  bool pop(Entry* entry);
  void generate(std::int32_t parent, std::int32_t action);
  void extract(std::int32_t node);
  std::int64_t bytes() const;

  const GroundTask* task_ = nullptr;
  LmCut* lm_cut_ = nullptr;
  std::int64_t expanded_ = 0;
  StateTable states_;
  Chunks<Node> nodes_;
  // Entries as a binary heap on (f, h, newest first).
  struct HeapEntry {
    std::int64_t f, h;
    std::int64_t serial;
    Entry entry;
    bool operator<(const HeapEntry& other) const {
      if (f != other.f) return f > other.f;
      if (h != other.h) return h > other.h;
      return serial < other.serial;
    }
  };
  ChunkedHeap<HeapEntry> heap_;
  std::int64_t serial_ = 0;
  StubbornSets stubborn_;
  Symmetry symmetry_;
  bool symmetry_used_ = false;
  bool bound_used_ = false;
  std::vector<Word> next_, key_;
  std::vector<std::int32_t> plan_;
  std::int64_t lower_bound_ = 0;
  std::int64_t upper_bound_ = 0;
  std::int64_t generated_ = 0;
};

}  // namespace goalnet::planner

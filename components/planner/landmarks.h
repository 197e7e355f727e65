// Landmarks: conditions that hold at some time in every plan, and the order in which they come. A goal tower
// is built from the bottom because "the block below stands" must come before "the block above stands on it",
// although no single action says so. Found on the delete relaxation (Keyder, Richter and Helmert, ECAI 2010);
// orders as in LAMA (Richter and Westphal, JAIR 2010).
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/pair_reachability.h"
#include "components/planner/relaxed_task.h"

namespace goalnet::planner {

class Landmarks {
 public:
  // The goals are always among them; in large tasks, or when the budget runs out, they may be all.
  void find(const RelaxedTask& relaxed, const PairReachability& pairs, const Word* initial, Budget& budget);

  std::int32_t count() const { return static_cast<std::int32_t>(conditions_.size()); }
  std::size_t words() const { return words_; }  // of a set of landmarks

  // Adds to a set of landmarks those that hold in `state`: what has been reached on the way to it.
  void note(const Word* state, Word* reached) const;
  // How many landmarks are still to come: not reached yet, or needed again, or reached before something that
  // must come first, so that they will have to be given up for it.
  std::int32_t missing(const Word* state, const Word* reached);
  // Whether the action makes a landmark true that may come next,
  // in the state last counted.
  bool leads_on(const GroundAction& action) const;

 private:
  // Sets of landmarks are rows of bits.
  static bool in(const Word* words, std::int32_t i) {
    return ((words[static_cast<std::size_t>(i) >> 6] >> (static_cast<std::size_t>(i) & 63u)) & 1u) != 0;
  }
  static void put(Word* words, std::int32_t i) {
    words[static_cast<std::size_t>(i) >> 6] |= Word{1} << (static_cast<std::size_t>(i) & 63u);
  }
  void collect(const Word* initial, Budget& budget);
  void order_by_need(Budget& budget);
  void order_reasonably(const PairReachability& pairs, Budget& budget);
  bool interferes(std::int32_t first, std::int32_t second, const PairReachability& pairs) const;
  // `reasonable`: not a must, but the other way round something would be done twice.
  void add_order(std::int32_t before, std::int32_t after, bool reasonable);
  Word* row(std::vector<Word>& rows, std::int32_t i) const {
    return rows.data() + static_cast<std::size_t>(i) * words_;
  }
  const Word* row(const std::vector<Word>& rows, std::int32_t i) const {
    return rows.data() + static_cast<std::size_t>(i) * words_;
  }
  bool too_early(std::int32_t landmark) const;

  const RelaxedTask* relaxed_ = nullptr;
  const GroundTask* task_ = nullptr;
  std::size_t words_ = 1;
  std::vector<ConditionId> conditions_;       // by landmark
  std::vector<std::uint8_t> is_goal_;         // by landmark
  std::vector<std::int32_t> of_proposition_;  // landmark of a proposition, or -1
  std::vector<Word> before_;                  // by landmark: those that reasonably come before it
  std::vector<Word> after_all_;               // by landmark: all that come after it, also indirectly
  std::vector<std::vector<std::int32_t>>
      just_before_;  // by landmark: what holds right before it first becomes true
  std::vector<std::vector<std::int32_t>> just_after_;  // the same, seen from the other side
  std::vector<std::vector<std::int32_t>> needed_for_;  // by landmark: what can never become true without it
  std::vector<std::int32_t> latest_first_;             // landmarks, each after all that come after it
  std::vector<std::int32_t> ordered_;  // landmarks that others reasonably come before, earliest first
  std::vector<std::uint8_t> open_;     // by landmark, while counting: still to come
  std::vector<Word> settled_;          // while counting: reached, and not too early
  std::vector<std::vector<Literal>>
      comes_with_;  // by landmark: what all actions that first reach it do besides
  // By proposition: its landmarks as sorted propositions, while they are computed.
  std::vector<std::vector<Proposition>> sets_;
  std::vector<std::uint8_t> known_;
};

}  // namespace goalnet::planner

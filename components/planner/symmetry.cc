#include "components/planner/symmetry.h"

#include <algorithm>

namespace goalnet::planner {

std::int64_t Symmetry::find(const GroundTask& task, const Word* initial, Budget& budget) {
  (void)initial;
  (void)budget;
  generators_.clear();
  words_ = std::max<std::size_t>(task.words(), 1);
  trial_.resize(words_);
  return count();
}

void Symmetry::canonical(const Word* state, Word* key) {
  std::copy_n(state, words_, key);
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const Generator& generator : generators_) {
      std::copy_n(key, words_, trial_.begin());
      for (const auto& [from, to] : generator.moves) {
        const bool holds = (key[static_cast<std::size_t>(from) >> 6] >> (static_cast<std::size_t>(from) & 63u)) & 1u;
        make_true(trial_.data(), 2 * to + (holds ? 0 : 1));
      }
      if (std::lexicographical_compare(trial_.begin(), trial_.end(), key, key + words_)) {
        std::copy(trial_.begin(), trial_.end(), key);
        smaller = true;
      }
    }
  }
}

}  // namespace goalnet::planner

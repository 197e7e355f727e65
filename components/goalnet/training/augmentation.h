// Semantic replacement of objects: the same demonstration with another thing that means something similar.
#pragma once

#include <random>
#include <vector>

#include "components/goalnet/training/episodes.h"
#include "components/goalnet/training/vocabulary.h"

namespace goalnet::inference::training {

class Augmentation {
 public:
  // Which classes can stand for one another: alike in word vectors, and able to do the same in the grammar.
  Augmentation(const Vocabulary& vocabulary, const std::vector<Episode>& episodes);

  // A grounded object of the episode and a similar one of another class trade places in all states and goals,
  // and the word that named the first becomes a word that names the second. The episode itself where nothing
  // fits.
  Episode replaced(const Episode& episode, std::mt19937_64& random) const;

 private:
  const Vocabulary& vocabulary_;
  std::vector<std::vector<std::uint8_t>> similar_;  // by class, by class
  std::vector<std::vector<std::string>> words_;     // by class: words that have named it, most frequent first
};

}  // namespace goalnet::inference::training

#include "components/goalnet/language/clause.h"

#include <algorithm>

namespace goalnet::inference {

bool Clause::has(const std::string& word) const {
  return std::find(words.begin(), words.end(), word) != words.end() || has_particle(word) ||
         std::any_of(phrases.begin(), phrases.end(),
                     [&](const NounPhrase& p) { return p.phrase == word || p.has(word); });
}

bool Clause::has_particle(const std::string& word) const {
  return std::find(particles.begin(), particles.end(), word) != particles.end();
}

const NounPhrase* Clause::first(Role role) const {
  for (const NounPhrase& phrase : phrases)
    if (phrase.role == role) return &phrase;
  return nullptr;
}

}  // namespace goalnet::inference

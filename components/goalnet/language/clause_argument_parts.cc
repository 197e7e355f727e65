// Single things behind a verb: particles, "for me".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// "for me", "for two minutes", "for the guests", "two cushions for the sofa".
std::size_t ClauseParser::for_whom(std::size_t i, std::size_t end, Clause& clause) {
  NounPhrase phrase;
  std::size_t done = reader_.read(i + 1, end, phrase);
  // "two cushions for the sofa", "a scoop for the bowl"
  const bool puts = clause.frame == Frame::kPlace || clause.frame == Frame::kScoop ||
                    clause.frame == Frame::kAdd || clause.frame == Frame::kSqueeze ||
                    clause.frame == Frame::kPour;
  if (language_.hears_people() && puts && done != i + 1 && !phrase.person && !phrase.unknown &&
      !phrase.bare() && !phrase.pronoun && clause.first(Role::kDestination) == nullptr) {
    phrase.role = Role::kDestination, phrase.where = Where::kTo;
    clause.phrases.push_back(std::move(phrase));
    return done;
  }
  if (language_.hears_people() && clause.frame == Frame::kSwap && done != i + 1 && !phrase.person &&
      !phrase.unknown && !phrase.bare() && clause.first(Role::kDirect) != nullptr) {
    phrase.role = Role::kWith;  // "swap the bowl in the microwave for the mug"
    clause.phrases.push_back(std::move(phrase));
    return done;
  }
  clause.to_person = clause.to_person || phrase.person;
  if (done == i + 1 && done < end && !opens_command(done, end)) ++done;
  if (done < end && language_.time_unit(words_[done])) ++done;
  return done;
}

std::size_t ClauseParser::particle(std::size_t i, std::size_t end, Clause& clause, Role& role) {
  const std::string& word = words_[i];
  const bool noun_next = reader_.starts(i + 1, end);
  if ((word == "out" || word == "off") && i + 1 < end && words_[i + 1] == "of") {
    NounPhrase phrase;
    const std::size_t done = reader_.read(i + 2, end, phrase);
    role = Role::kSource;
    phrase.role = role;
    if (done != i + 2 && !phrase.hand) clause.phrases.push_back(std::move(phrase));
    clause.particles.push_back(word);
    return std::max(done, i + 2);
  }
  // "take the coke off the stove"
  if (word == "off" && noun_next && clause.first(Role::kDirect) != nullptr && clause.frame != Frame::kTurn &&
      clause.frame != Frame::kStop) {
    NounPhrase phrase;
    const std::size_t done = reader_.read(i + 1, end, phrase);
    role = Role::kSource;
    phrase.role = role;
    clause.phrases.push_back(std::move(phrase));
    return done;
  }
  clause.particles.push_back(word);
  return i + 1;
}

}  // namespace goalnet::inference

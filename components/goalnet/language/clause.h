// A sentence as clauses: a verb's frame with the things it is about, by role.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/language/noun_phrase.h"

namespace goalnet::inference {

enum class Mood : std::uint8_t {
  kCommand,    // "open the fridge"; also "the fridge should be open"
  kForbidden,  // "do not open the fridge", "without opening the fridge"
  kStatement,  // "the mug is dirty": says what "it" will mean, and what may be wished
  kQuestion,   // "why is the salt there?"
};

struct Clause {
  Mood mood = Mood::kCommand;
  Frame frame = Frame::kNone;
  std::string verb;
  std::vector<NounPhrase> phrases;
  std::vector<std::string> particles;  // on, off, up, down, out, away, back
  std::vector<std::string> unknown;    // words that mean nothing here and stand where a thing should
  std::vector<std::string> words;
  std::string state;       // "open" of "leave the door open", "dirty" of "the mug is dirty"
  bool to_person = false;  // "bring me", "to the guest", "here"
  bool wish = false;       // "I want a coke"
  bool negative = false;   // of a statement: "is not on"
  bool asked = false;      // of a statement: "..., do something about it"
  bool belongs = false;    // "the remote goes on the shelf"
  bool supposed = false;   // "should be", "must be", "ought to be": may only tell where it is thought to be
  bool weak = false;       // "I want to read": asks for something only where nothing else does
  bool reason = false;     // weak, and mostly why something else is asked: "I want to sit down, ..."
  // "if the tap is on, ...": the statement that must hold; empty: no condition.
  std::vector<Clause> condition;
  int condition_number = 0;  // commands of the same one are judged once, before any of them is done
  bool otherwise = false;    // "..., otherwise ...": where the condition does not hold

  bool has(const std::string& word) const;
  bool has_particle(const std::string& word) const;
  const NounPhrase* first(Role role) const;
};

struct ParsedSentence {
  std::vector<Clause> clauses;      // in the order in which they are to be done
  std::vector<std::string> stray;   // words outside any clause that nobody could read
  std::vector<std::string> passed;  // words of parts that were passed over, as they ask for nothing here
  bool for_later = false;           // "in an hour, ..."
  bool wonders = false;             // "I wonder if ...": asks
  std::string problem;              // why the sentence cannot be a request at all ("if ..."); empty: none
};

ParsedSentence parse_clauses(const Words& words, const Language& language, const Lexicon& lexicon);

}  // namespace goalnet::inference

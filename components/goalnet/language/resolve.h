// From noun phrases to objects of the world.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "components/goalnet/language/clause.h"
#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/sym_state.h"

namespace goalnet::inference {

// What may be meant in a role: a thing to move, a place to put things, a device, anything.
enum class Sort : std::uint8_t { kAny, kMovable, kPlace, kDevice, kVessel };

// How far things are from the robot, by name [m]; those not listed are farther than all.
using Distances = std::map<std::string, double>;
inline constexpr double kFar = 1000.0;  // [m] where the distance is not known

// How sure the choice of objects was: signs of a misreading.
struct Doubts {
  int ties = 0;     // several objects fitted equally well and nothing told which
  int loose = 0;    // what was said of an object holds for none ("the empty cup" where all are full)
  int generic = 0;  // named by a word for many kinds of things ("dish")
};

// The number at the end of a name: "Pillow_4" -> 4; 0 where there is none.
int number_of(const std::string& name);

class Resolver {
 public:
  Resolver(const Instruction& instruction, const Lexicon& lexicon, const Language& language,
           const Symbols& symbols, const Distances* distances)
      : instruction_(instruction),
        lexicon_(lexicon),
        language_(language),
        symbols_(symbols),
        distances_(distances) {}

  // All objects that the phrase may mean, of the sort, best first: as what is said of them, held, near, by
  // distance, then in the order of their names. Where somebody fits what was said, only those that do.
  std::vector<Symbol> options(const NounPhrase& phrase, Sort sort, const SymState& now);
  // As many of the options as the phrase asks for.
  std::vector<Symbol> chosen(const NounPhrase& phrase, std::vector<Symbol> options);
  // What a phrase names, whatever its sort; for messages.
  std::vector<Symbol> named(const NounPhrase& phrase) const;

  bool is_of_class(Symbol object, std::string_view class_name) const;
  bool is_vessel(Symbol object) const;
  const ObjectClass* class_of(Symbol object) const;
  // Objects of the world of a sort.
  std::vector<Symbol> all(Sort sort, const SymState& now) const;
  const std::vector<SeenObject>& objects() const { return instruction_.objects; }
  Symbol xbox() const;
  Symbol ice_cream() const;
  bool exists(Symbol object) const { return instruction_.find(object) >= 0; }
  // Whether something stands on or in it.
  bool taken(Symbol place, const SymState& now) const;
  std::vector<Symbol> things_at(Symbol place, const SymState& now) const;
  Symbol place_of(Symbol object, const SymState& now) const;
  std::string name(Symbol object) const { return symbols_.name(object); }
  double distance(Symbol object) const;

  // How it is before anything is done. "Put it on the armchair that has none" is
  // not the one that it was just taken from.
  void begins_with(const SymState& start) { start_ = start; }
  // Objects spoken of so far: "the other one" is none of them.
  void remember(const std::vector<Symbol>& objects);
  Doubts& doubts() { return doubts_; }
  // Whether it is where the phrase says: "the book that is on the table", "the books from the table and the
  // couch".
  bool is_where_said(Symbol object, const NounPhrase& phrase, const SymState& now) const {
    return std::any_of(phrase.at.begin(), phrase.at.end(),
                       [&](const NounPhrase& place) { return is_at(object, place, now) != place.negated; });
  }
  // Whether a vessel holds nothing.
  bool is_empty(Symbol object, const SymState& now) const;

 private:
  struct Option {
    Symbol symbol;
    int faults;  // how much of what was said does not hold
    NameLevel level;
    double order;  // held, near, far
    std::string name;
  };
  bool fits(Symbol object, Sort sort, const SymState& now) const;
  NameLevel level(const NounPhrase& phrase, Symbol object, ClassId class_id, Sort sort,
                  const SymState& now) const;
  int faults(const NounPhrase& phrase, const SeenObject& object, const SymState& now) const;
  bool is_at(Symbol object, const NounPhrase& place, const SymState& now, bool exactly = false) const;
  bool named_exactly(const NounPhrase& place) const;

  const Instruction& instruction_;
  const Lexicon& lexicon_;
  const Language& language_;
  const Symbols& symbols_;
  const Distances* distances_;
  std::optional<SymState> start_;
  std::vector<Symbol> spoken_;
  Doubts doubts_;
};

}  // namespace goalnet::inference

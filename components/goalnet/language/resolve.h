// From noun phrases to objects of the world.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "components/goalnet/language/clause.h"
#include "components/goalnet/sym_state.h"

namespace goalnet::inference {

// What may be meant in a role: a thing to move, a place to put things, a device, anything.
enum class Sort : std::uint8_t { kAny, kMovable, kPlace, kDevice, kVessel };

class Resolver {
 public:
  Resolver(const Instruction& instruction, const Lexicon& lexicon, const Symbols& symbols)
      : instruction_(instruction), lexicon_(lexicon), symbols_(symbols) {}

  // All objects that the phrase may mean, of the sort, best first: as the adjectives and modifiers say, held,
  // near, then in the order of their names. Only the best level of naming counts. `source`: where they are
  // said to be.
  std::vector<Symbol> options(const NounPhrase& phrase, Sort sort, const SymState& now,
                              const NounPhrase* source = nullptr) const;

  // As many of the options as the phrase asks for.
  std::vector<Symbol> chosen(const NounPhrase& phrase, std::vector<Symbol> options) const;

  bool is_of_class(Symbol object, std::string_view class_name) const;
  const ObjectClass* class_of(Symbol object) const;
  // Objects of the world of a sort.
  std::vector<Symbol> all(Sort sort, const SymState& now) const;
  const Instruction& instruction() const { return instruction_; }
  std::string name(Symbol object) const { return symbols_.name(object); }

 private:
  bool fits(Symbol object, Sort sort, const SymState& now) const;
  bool is_at(Symbol object, const std::string& place_phrase, const SymState& now) const;
  bool is_empty(Symbol object, const SymState& now) const;

  const Instruction& instruction_;
  const Lexicon& lexicon_;
  const Symbols& symbols_;
};

}  // namespace goalnet::inference

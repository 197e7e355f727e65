// Clauses to actions, one frame at a time, played through in SymSim so that later clauses see what earlier
// ones did.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/language/clause.h"
#include "components/goalnet/language/resolve.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

class FrameActions {
 public:
  FrameActions(const Instruction& instruction, const Lexicon& lexicon, const Language& language,
               const Symbols& symbols, const SymState& start)
      : resolver_(instruction, lexicon, symbols), language_(language), now_(start) {}

  // Adds what the clause asks for; otherwise adds nothing and says why not, in one sentence.
  std::string add(const Clause& clause);
  const std::vector<SymAction>& macros() const { return macros_; }

 private:
  using Problem = std::string;  // empty: none

  const NounPhrase* first(const Clause& clause, Role role) const;
  std::vector<Symbol> direct(const Clause& clause, Sort sort, Problem& problem);
  std::vector<Symbol> of_role(const Clause& clause, Role role, Sort sort, Problem& problem);
  Symbol place(const Clause& clause, Problem& problem);
  Symbol mentioned_content(const Clause& clause, Role role) const;
  Symbol vessel_with(Symbol content) const;
  Symbol burner_for(Symbol object) const;
  Problem unknown_thing(const NounPhrase& phrase) const;

  Problem act(const SymAction& macro);
  Problem keep(Symbol x, Symbol y, bool inside);
  Problem turn_on(Symbol device, bool on, int number);
  Problem fill_with_water(Symbol vessel);

  Problem go(const Clause& clause);
  Problem take(const Clause& clause);
  Problem put(const Clause& clause);
  Problem discard(const Clause& clause);
  Problem fill(const Clause& clause);
  Problem pour(const Clause& clause);
  Problem empty(const Clause& clause);
  Problem turn(const Clause& clause, int on);
  Problem door(const Clause& clause, bool open);
  Problem wash(const Clause& clause);
  Problem heat(const Clause& clause, bool boil);
  Problem add_to(const Clause& clause);
  Problem scoop(const Clause& clause);
  Problem insert(const Clause& clause);
  Problem release(const Clause& clause);
  Problem television(const Clause& clause);

  Resolver resolver_;
  const Language& language_;
  SymState now_;
  std::vector<SymAction> macros_;
  std::vector<Symbol> last_;  // what "it" means: the objects of the clause before
};

}  // namespace goalnet::inference

// What a plain instruction asks for, by its grammar: verbs open frames, frames become actions in this world.
// It says plainly when it does not understand; the learned ranker (ranker/) covers what grammar cannot.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/language/clause.h"
#include "components/goalnet/language/resolve.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

struct Understanding {
  std::vector<SymAction> macros;      // in order; see with_means
  std::vector<SymDelta> steps;        // what each of them is for; empty where nothing
  bool complete = false;              // every clause was understood
  std::vector<std::string> problems;  // why a clause was not: one sentence each
  bool unknown_thing = false;         // all of the problems: things that are not here; the rest was read
  bool for_later = false;             // a wish that nobody here keeps until then
  bool only_forbids = false;          // "do not open the fridge"
  bool only_asks = false;             // "I wonder if the fridge is open"
  bool question = false;              // nothing is asked for, but something is asked
  bool nothing_known = false;         // no verb, or nothing it could be about
  bool no_such_number = false;        // "channel 9", "shelf 4": read, but there are fewer
  bool contradicted = false;          // "the tv is on, turn it off" where it is off: read, but it is not so

  Doubts doubts;  // how sure the choice of objects was
};

class FrameReader {
 public:
  // `at_home`: what is read will be done by a planner for people, not compared with demonstrations. The tap
  // that was only turned on to fill something is turned off, and a vessel that is to be poured from must be
  // empty in the end.
  FrameReader(const Lexicon& lexicon, const Language& language, const Symbols& symbols, bool at_home = false)
      : lexicon_(lexicon), language_(language), symbols_(symbols), at_home_(at_home) {}

  // Reads the words that the instruction was seen with.
  Understanding read(const Instruction& instruction, const SymState& start) const;
  // Reads `words`; of the instruction only the objects count. `distances` may be null.
  Understanding read(const Words& words, const Instruction& instruction, const SymState& start,
                     const Distances* distances) const;

 private:
  const Lexicon& lexicon_;
  const Language& language_;
  const Symbols& symbols_;
  bool at_home_;
};

}  // namespace goalnet::inference

// What a plain instruction asks for, by its grammar: verbs open frames, frames become actions in this world.
// It says plainly when it does not understand; the learned ranker (ranker/) covers what grammar cannot.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/language/clause.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

struct Understanding {
  std::vector<SymAction> macros;      // in order; see with_means
  bool complete = false;              // every clause was understood
  std::vector<std::string> problems;  // why a clause was not: one sentence each
  bool nothing_known = false;         // no verb, or nothing it could be about
};

class FrameReader {
 public:
  FrameReader(const Lexicon& lexicon, const Language& language, const Symbols& symbols)
      : lexicon_(lexicon), language_(language), symbols_(symbols) {}

  Understanding read(const Instruction& instruction, const SymState& start) const;

 private:
  const Lexicon& lexicon_;
  const Language& language_;
  const Symbols& symbols_;
};

}  // namespace goalnet::inference

#include "components/goalnet/language/frames.h"

#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

Understanding FrameReader::read(const Instruction& instruction, const SymState& start) const {
  Understanding result;
  const ParsedSentence sentence = parse_clauses(instruction, language_);
  if (sentence.clauses.empty()) {
    result.nothing_known = true;
    std::string problem = "there is no verb that a robot could act on";
    if (!sentence.stray.empty()) problem += "; " + language_.unknown_word(sentence.stray.front());
    result.problems.push_back(problem);
    return result;
  }
  FrameActions actions(instruction, lexicon_, language_, symbols_, start);
  std::size_t understood = 0;
  for (const Clause& clause : sentence.clauses) {
    const std::string problem = actions.add(clause);
    if (problem.empty())
      ++understood;
    else
      result.problems.push_back(problem);
  }
  if (!sentence.stray.empty()) result.problems.push_back(language_.unknown_word(sentence.stray.front()));
  result.macros = actions.macros();
  result.complete = understood == sentence.clauses.size() && sentence.stray.empty();
  return result;
}

}  // namespace goalnet::inference

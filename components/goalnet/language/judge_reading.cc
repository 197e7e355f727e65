// The signs of how sure to be of a reading.
#include <algorithm>

#include "components/goalnet/language/left_unused.h"
#include "components/goalnet/language/robot_language.h"

namespace goalnet::inference {
namespace {

constexpr int kMostCounted = 3;      // more of the same says little more
constexpr std::ptrdiff_t kMuch = 8;  // words; "turn off the tap" may well be about one that is off

double count(std::size_t n) { return static_cast<double>(std::min<std::size_t>(n, kMostCounted)); }

// Where the robot stands counts only where it is to go somewhere and nothing else.
bool is_so(const SymDelta& step, const SymState& state) {
  const auto near = [](SymFact fact) { return relation_of(fact) == Relation::kNear; };
  const bool only_goes = step.removed.empty() && std::all_of(step.added.begin(), step.added.end(), near);
  return std::all_of(step.added.begin(), step.added.end(),
                     [&](SymFact fact) { return state.has(fact) || (near(fact) && !only_goes); }) &&
         std::none_of(step.removed.begin(), step.removed.end(),
                      [&](SymFact fact) { return state.has(fact) && !near(fact); });
}

bool is_word(const std::string& token) { return token.find_first_of(".,?!:;-()") == std::string::npos; }

}  // namespace

RobotLanguage::Judgement RobotLanguage::judge(const std::vector<std::string>& tokens, const Reading& reading,
                                              const SymState& start, const Distances* distances) const {
  const Understanding& understanding = reading.understanding;
  const LeftUnused left = left_unused(normal_words(tokens, *language_), understanding.macros,
                                      reading.instruction, start, *language_, *lexicon_, symbols_);
  const std::vector<SentencePart> all = parts(tokens);
  const FrameReader reader(*lexicon_, *language_, symbols_, true);
  double unheard = 0, slips = 0;
  std::vector<std::string> unused = left.words;
  for (const SentencePart& part : all)
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const bool turns = turns_round(tokens[i]);
      if (!turns && !owns_slip(tokens[i])) continue;
      std::vector<std::string> without = tokens;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      const Understanding other =
          reader.read(normal_words(without, *language_), reading.instruction, start, distances);
      if (!other.complete || other.macros != understanding.macros) continue;
      (turns ? unheard : slips) += 1 - background(part);
      unused.push_back(tokens[i]);
    }
  const auto& text = reading.words.text;
  const ParsedSentence sentence = parse_clauses(reading.words, *language_, *lexicon_);
  const auto conditions = std::count_if(sentence.clauses.begin(), sentence.clauses.end(),
                                        [](const Clause& clause) { return !clause.condition.empty(); });
  const bool idle = std::all_of(understanding.steps.begin(), understanding.steps.end(),
                                [&](const SymDelta& step) { return is_so(step, start); }) &&
                    std::count_if(tokens.begin(), tokens.end(), is_word) > kMuch;
  const auto any = [](int n) { return n > 0 ? 1.0 : 0.0; };
  const auto counted = [](int n) { return count(static_cast<std::size_t>(std::max(n, 0))); };
  return {{any(understanding.doubts.ties), any(understanding.doubts.loose), any(understanding.doubts.generic),
           counted(left.things), counted(left.places), counted(left.beside), counted(left.numbers),
           counted(left.denied_used), std::min<double>(unheard, kMostCounted),
           std::min<double>(slips, kMostCounted), idle ? 1.0 : 0.0,
           std::find(text.begin(), text.end(), "correction") != text.end() ? 1.0 : 0.0,
           counted(static_cast<int>(conditions))},
          unused};
}

}  // namespace goalnet::inference

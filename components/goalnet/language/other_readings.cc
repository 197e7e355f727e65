// What a sentence that makes no sense as it stands may have been meant to say.
#include <algorithm>
#include <array>

#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

constexpr int kMostSpellings = 12;  // of a sentence

}  // namespace

void RobotLanguage::other_readings(const std::vector<std::string>& tokens, const FrameReader& reader,
                                   const SymState& start, const Distances* distances, Reading& reading) {
  const auto makes_sense = [&](const std::vector<std::string>& other) {
    Words words = normal_words(other, *language_);
    Understanding understanding = reader.read(words, reading.instruction, start, distances);
    if (!understanding.complete) return false;
    reading.words = std::move(words), reading.understanding = std::move(understanding);
    return true;
  };
  int tries = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    // "a glass of coke" means no glass off the coke
    if (tokens[i] == "of" && i > 0 && language_->holds_things(singular(tokens[i - 1]))) continue;
    for (const std::string& other : language_->corrections(tokens[i])) {
      if (other == language_->correct(tokens[i])) continue;
      if (++tries > kMostSpellings) return;
      std::vector<std::string> spelled = tokens;
      spelled[i] = other;
      if (makes_sense(spelled)) return;
    }
  }
  if (const auto plain = with_known_verbs(tokens); plain != tokens && makes_sense(plain)) return;
  if (const auto plain = without_describing(tokens); plain != tokens && makes_sense(plain)) return;
  // Perhaps it makes sense without a part that names nothing here ("see the problem?", "left one").
  std::vector<std::string> kept;
  for (std::size_t begin = 0; begin < tokens.size();) {
    std::size_t end = begin;
    while (!ends_part(tokens, end)) ++end;
    if (!names_nothing(tokens, begin, end))
      kept.insert(kept.end(), tokens.begin() + static_cast<long>(begin),
                  tokens.begin() + static_cast<long>(std::min(end + 1, tokens.size())));
    begin = end + 1;
  }
  if (kept.size() < tokens.size() && !kept.empty() && makes_sense(kept)) return;
  for (const auto& request : without_background(tokens)) {
    if (!makes_sense(request.words)) continue;
    // Each part that is left and surely asks for something must have been read as such.
    const bool all_read = std::none_of(request.less.begin(), request.less.end(), [&](const auto& less) {
      const Understanding other =
          reader.read(normal_words(less, *language_), reading.instruction, start, distances);
      return other.complete && other.macros == reading.understanding.macros;
    });
    if (all_read) return;
    reading.understanding.complete = false;
    reading.understanding.macros.clear(), reading.understanding.steps.clear();
    reading.understanding.problems = {"it is not clear which part of that is the request; say it on its own"};
  }
}

// "submerge the plate in the sink": a way of moving things, by what it moves and where.
std::vector<std::string> RobotLanguage::with_known_verbs(const std::vector<std::string>& tokens) const {
  using std::string_view_literals::operator""sv;
  static constexpr std::array kTo = {"in"sv, "on"sv, "into"sv, "onto"sv, "to"sv};
  static constexpr std::array kFrom = {"from"sv, "off"sv};
  std::vector<std::string> plain = tokens;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool first = i == 0 || ends_part(tokens, i - 1) || tokens[i - 1] == "and" ||
                       tokens[i - 1] == "then" || tokens[i - 1] == "please";
    if (!first || language_->known(tokens[i]) || !language_->moves(tokens[i])) continue;
    bool to = false, from = false;
    for (std::size_t k = i + 1; !ends_part(tokens, k); ++k) {
      to = to || one_of(tokens[k], kTo);
      from = from || one_of(tokens[k], kFrom);
    }
    if (to || from) plain[i] = to ? "put" : "take";
  }
  return plain;
}

// "put it somewhere sensible": but what a verb is said to bring about counts ("turn blue").
std::vector<std::string> RobotLanguage::without_describing(const std::vector<std::string>& tokens) const {
  std::vector<std::string> plain;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool of_verb = i == 0 || ends_part(tokens, i - 1) || language_->english_verb(tokens[i - 1]);
    if (of_verb || language_->known(tokens[i]) || !language_->describes(tokens[i]))
      plain.push_back(tokens[i]);
  }
  return plain;
}

// Whether nothing of this place, nothing to do and no "not" or "if" is spoken of.
bool RobotLanguage::names_nothing(const std::vector<std::string>& tokens, std::size_t begin,
                                  std::size_t end) const {
  if (needs_unknown(tokens, {.begin = begin, .end = end, .within = false, .signs = {}})) return false;
  static constexpr std::array<std::string_view, 44> kTurns = {
      "not",    "no",       "never",    "dont",   "without", "except", "instead", "or",       "if",
      "unless", "before",   "after",    "until",  "till",    "then",   "hour",    "hours",    "minutes",
      "minute", "mins",     "tomorrow", "oclock", "pm",      "am",     "noon",    "midnight", "later",
      "when",   "whenever", "every",    "week",   "day",     "monday", "weekend", "tonight",  "it",
      "them",   "that",     "those",    "both",   "one",     "all",    "rest",    "other"};
  for (std::size_t i = begin; i < end; ++i) {
    const std::string& word = tokens[i];
    const std::string stem = singular(word);
    if (language_->meaningful(word) || language_->meaningful(stem) || lexicon_->is_word_of_name(stem) ||
        language_->may_be_a_slip(word) || std::find(kTurns.begin(), kTurns.end(), word) != kTurns.end() ||
        language_->wanted_by_state(word) != Frame::kNone || language_->wish(word) != nullptr ||
        word.size() > 20)
      return false;
  }
  return end > begin;
}

}  // namespace goalnet::inference

#include "components/goalnet/language/robot_language.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <initializer_list>
#include <sstream>

#include "components/core/config_path.h"

namespace goalnet::inference {
namespace {

constexpr int kMostSpellings = 12;  // other spellings that are tried of a sentence

Expected<std::string> text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return fail(Outcome::kInvalidRequest, path + ": cannot be read");
  return text.str();
}

}  // namespace

Expected<std::unique_ptr<RobotLanguage>> RobotLanguage::load(Symbols& symbols) {
  std::unique_ptr<RobotLanguage> robot(new RobotLanguage(symbols));
  constexpr int kFiles = 6;
  std::string texts[kFiles], paths[kFiles];
  const char* names[kFiles] = {"language/household.json",  "language/english.json", "language/words.json",
                               "language/confidence.json", "language/kinds.json",   "language/talk.json"};
  for (int i = 0; i < kFiles; ++i) {
    paths[i] = config_path(names[i]);
    auto text = text_of(paths[i]);
    if (!text) return tl::unexpected(text.error());
    texts[i] = std::move(*text);
  }
  auto lexicon = Lexicon::parse(texts[0], paths[0], symbols);
  if (!lexicon) return tl::unexpected(lexicon.error());
  robot->lexicon_ = std::make_unique<Lexicon>(std::move(*lexicon));
  if (auto added = robot->lexicon_->add_names(texts[1], paths[1]); !added)
    return tl::unexpected(added.error());
  if (auto added = robot->lexicon_->add_names(texts[5], paths[5]); !added)
    return tl::unexpected(added.error());
  auto language = Language::parse(texts[0], paths[0], *robot->lexicon_, symbols);
  if (!language) return tl::unexpected(language.error());
  robot->language_ = std::make_unique<Language>(std::move(*language));
  if (auto added = robot->language_->add_english(texts[1], paths[1]); !added)
    return tl::unexpected(added.error());
  if (auto added = robot->language_->add_other_words(texts[2], paths[2]); !added)
    return tl::unexpected(added.error());
  if (auto added = robot->language_->add_kinds(texts[4], paths[4]); !added)
    return tl::unexpected(added.error());
  if (auto added = robot->language_->add_talk(texts[5], paths[5]); !added)
    return tl::unexpected(added.error());
  auto confidence = ReadingConfidence::parse(texts[3], paths[3]);
  if (!confidence) return tl::unexpected(confidence.error());
  robot->confidence_ = *confidence;
  return robot;
}

RobotLanguage::Reading RobotLanguage::read(const std::vector<std::string>& tokens,
                                           const std::vector<std::string>& objects, const SymState& start,
                                           const Distances* distances) {
  // Things that the lexicon does not list are known by their names from here on.
  for (const std::string& object : objects)
    if (const Symbol symbol = symbols_.intern(object); symbol != symbol::kNone && symbol != symbol::kRobot)
      lexicon_->class_of(symbol, symbols_);
  // Parts of things are here with them, though worlds do not list them.
  std::vector<std::string> with_parts = objects;
  const auto add_parts = [&](const char* thing, std::initializer_list<const char*> parts) {
    if (std::find(objects.begin(), objects.end(), thing) != objects.end())
      with_parts.insert(with_parts.end(), parts.begin(), parts.end());
  };
  add_parts("Fridge", {"FridgeLeft", "FridgeRight", "FridgeLeftDoor", "FridgeRightDoor", "FridgeButton"});
  add_parts("Microwave", {"MicrowaveButton"});
  add_parts("Stove", {"StoveKnob_1", "StoveKnob_2", "StoveKnob_3", "StoveKnob_4"});
  add_parts("Sink", {"SinkKnob"});
  Reading reading;
  reading.words = normal_words(tokens, *language_);
  reading.instruction = see_instruction({}, nullptr, with_parts, *lexicon_, *language_, symbols_);
  const FrameReader reader(*lexicon_, *language_, symbols_, true);
  reading.understanding = reader.read(reading.words, reading.instruction, start, distances);
  if (reading.understanding.complete || reading.understanding.for_later) return reading;
  // The likeliest spelling makes no sense: perhaps another one does.
  int tries = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    // "a glass of coke" means no glass off the coke
    if (tokens[i] == "of" && i > 0 && language_->holds_things(singular(tokens[i - 1]))) continue;
    for (const std::string& other : language_->corrections(tokens[i])) {
      if (other == language_->correct(tokens[i])) continue;
      if (++tries > kMostSpellings) return reading;
      std::vector<std::string> spelled = tokens;
      spelled[i] = other;
      Words words = normal_words(spelled, *language_);
      Understanding understanding = reader.read(words, reading.instruction, start, distances);
      if (!understanding.complete) continue;
      ++words.corrected;
      reading.words = std::move(words), reading.understanding = std::move(understanding);
      return reading;
    }
  }
  // Perhaps it makes sense without a part that names nothing here ("see the problem?", "left one").
  std::vector<std::string> kept;
  for (std::size_t begin = 0; begin < tokens.size();) {
    std::size_t end = begin;
    while (end < tokens.size() && tokens[end] != "." && tokens[end] != ",") ++end;
    if (!names_nothing(tokens, begin, end))
      kept.insert(kept.end(), tokens.begin() + static_cast<long>(begin),
                  tokens.begin() + static_cast<long>(std::min(end + 1, tokens.size())));
    begin = end + 1;
  }
  if (kept.size() == tokens.size() || kept.empty()) return reading;
  Words words = normal_words(kept, *language_);
  Understanding understanding = reader.read(words, reading.instruction, start, distances);
  if (!understanding.complete) return reading;
  ++understanding.passed_over;
  reading.words = std::move(words), reading.understanding = std::move(understanding);
  return reading;
}

// Whether nothing of this place, nothing to do and no "not" or "if" is spoken of.
bool RobotLanguage::names_nothing(const std::vector<std::string>& tokens, std::size_t begin,
                                  std::size_t end) const {
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

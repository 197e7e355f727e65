#include "components/goalnet/language/language.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

namespace goalnet::inference {
namespace {

using nlohmann::json;

constexpr std::array<std::pair<std::string_view, Frame>, 31> kFrames = {{
    {"go", Frame::kGo},         {"take", Frame::kTake},       {"place", Frame::kPlace},
    {"bring", Frame::kBring},   {"discard", Frame::kDiscard}, {"fill", Frame::kFill},
    {"pour", Frame::kPour},     {"empty", Frame::kEmpty},     {"turn", Frame::kTurn},
    {"start", Frame::kStart},   {"stop", Frame::kStop},       {"open", Frame::kOpen},
    {"close", Frame::kClose},   {"wash", Frame::kWash},       {"heat", Frame::kHeat},
    {"boil", Frame::kBoil},     {"add", Frame::kAdd},         {"squeeze", Frame::kSqueeze},
    {"scoop", Frame::kScoop},   {"insert", Frame::kInsert},   {"release", Frame::kRelease},
    {"change", Frame::kChange}, {"mute", Frame::kMute},       {"raise", Frame::kRaise},
    {"lower", Frame::kLower},   {"try", Frame::kTry},         {"make", Frame::kMake},
    {"swap", Frame::kSwap},     {"clear", Frame::kClear},     {"cool", Frame::kCool},
    {"play", Frame::kPlay},
}};

Frame frame_named(std::string_view name) {
  for (const auto& [known, frame] : kFrames)
    if (known == name) return frame;
  return Frame::kNone;
}

std::vector<std::string> split_words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

template <std::size_t N>
bool one_of(const std::string& word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

using std::string_view_literals::operator""sv;

constexpr int kMostRewrites = 1000;
// Words with a part in the grammar itself.
constexpr std::array kGrammarWords = {
    "on"sv,       "off"sv,     "up"sv,         "down"sv,      "out"sv,      "away"sv,  "over"sv,
    "in"sv,       "back"sv,    "into"sv,       "onto"sv,      "inside"sv,   "from"sv,  "with"sv,
    "under"sv,    "beside"sv,  "near"sv,       "it"sv,        "them"sv,     "this"sv,  "that"sv,
    "these"sv,    "those"sv,   "me"sv,         "us"sv,        "all"sv,      "both"sv,  "each"sv,
    "every"sv,    "one"sv,     "and"sv,        "then"sv,      "or"sv,       "not"sv,   "never"sv,
    "without"sv,  "before"sv,  "after"sv,      "until"sv,     "while"sv,    "if"sv,    "unless"sv,
    "because"sv,  "except"sv,  "everything"sv, "something"sv, "anything"sv, "rest"sv,  "other"sv,
    "is"sv,       "are"sv,     "was"sv,        "should"sv,    "must"sv,     "need"sv,  "want"sv,
    "please"sv,   "the"sv,     "wish"sv,       "use"sv,       "using"sv,    "let"sv,   "forgot"sv,
    "somebody"sv, "someone"sv, "nobody"sv,     "everybody"sv, "everyone"sv, "he"sv,    "she"sv,
    "whatever"sv, "better"sv,  "inside"sv,     "ensure"sv,    "there"sv,    "here"sv,  "ones"sv,
    "through"sv,  "around"sv,  "upon"sv,       "towards"sv,   "toward"sv,   "below"sv, "behind"sv,
    "against"sv,  "to"sv,      "at"sv,         "by"sv,        "of"sv,       "for"sv,   "you"sv,
    "i"sv,        "we"sv,      "your"sv,       "my"sv};

}  // namespace

int spelling_distance(std::string_view a, std::string_view b, int most) {
  constexpr std::size_t kLongest = 31;
  if (a.size() > kLongest || b.size() > kLongest) return most + 1;
  if (std::abs(static_cast<int>(a.size()) - static_cast<int>(b.size())) > most) return most + 1;
  std::array<std::array<int, kLongest + 1>, kLongest + 1> d{};
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return std::min(d[a.size()][b.size()], most + 1);
}

Expected<Language> Language::parse(std::string_view text, const std::string& name, const Lexicon& lexicon,
                                   Symbols& symbols) {
  Language language;
  language.lexicon_ = &lexicon;
  try {
    const json file = json::parse(text);
    for (const auto& [frame_name, words] : file.at("verbs").items()) {
      const Frame frame = frame_named(frame_name);
      if (frame == Frame::kNone)
        return fail(Outcome::kInvalidRequest, name + ": 'verbs' has the unknown frame '" + frame_name + "'");
      // The first frame that lists a word keeps it.
      for (const auto& word : words) language.verbs_.try_emplace(word.get<std::string>(), frame);
    }
    for (const auto& [content, phrases] : file.at("contents").items())
      for (const auto& phrase : phrases)
        language.contents_[phrase.get<std::string>()] = symbols.intern(content);
    for (const auto& word : file.at("fillers")) language.fillers_.insert(word.get<std::string>());
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  language.collect_vocabulary();
  return language;
}

void Language::collect_vocabulary() {
  vocabulary_.clear();
  for (const auto& [word, frame] : verbs_) vocabulary_.push_back(word);
  for (const auto& [word, base] : inflected_) vocabulary_.push_back(word);
  for (const auto& [word, count] : lexicon_->words()) vocabulary_.push_back(word);
  for (const std::string& word : fillers_) vocabulary_.push_back(word);
  for (const auto& [word, state] : states_) vocabulary_.push_back(word);
  for (const auto& [word, wish] : wishes_) vocabulary_.push_back(word);
  for (const std::string& word : questions_) vocabulary_.push_back(word);
  if (!rewrites_.empty()) {  // a language of whole sentences
    for (const auto& [first, list] : rewrites_)
      for (const Rewrite& rule : list)
        vocabulary_.insert(vocabulary_.end(), rule.from.begin(), rule.from.end());
    for (const std::string_view word : kGrammarWords) vocabulary_.emplace_back(word);
  }
  std::sort(vocabulary_.begin(), vocabulary_.end());
  vocabulary_.erase(std::unique(vocabulary_.begin(), vocabulary_.end()), vocabulary_.end());
}

// "a notch", "by two touches", "just a tad": how much more or less; nothing here has steps that could be
// told. The words are known, but no typing error is mended to one.
void Language::add_degrees(const std::vector<std::string>& units) {
  for (const std::string& unit : units)
    for (const std::string& word : {unit, unit + "s", unit + "es"}) {
      seen_.insert(word);
      for (const std::string by : {"", "by "})
        for (const std::string count :
             {"just a ", "just one ", "a wee ", "a little ", "a ", "one ", "another ", "two ", "three ",
              "a few ", "a couple of ", "a couple ", "some "}) {
          Rewrite rewrite{split_words(by + count + word), {}};
          rewrites_[rewrite.from.front()].push_back(std::move(rewrite));
        }
    }
}

Expected<void> Language::add_english(std::string_view text, const std::string& name) {
  std::vector<std::string> degrees;
  try {
    const json file = json::parse(text);
    for (const auto& [frame_name, words] : file.at("verbs").items()) {
      const Frame frame = frame_named(frame_name);
      if (frame == Frame::kNone)
        return fail(Outcome::kInvalidRequest, name + ": 'verbs' has the unknown frame '" + frame_name + "'");
      for (const auto& word : words) verbs_[word.get<std::string>()] = frame;
    }
    for (const auto& [form, base] : file.at("inflected").items()) inflected_[form] = base.get<std::string>();
    for (const auto& word : file.at("fillers")) fillers_.insert(word.get<std::string>());
    for (const auto& word : file.at("no_fillers")) fillers_.erase(word.get<std::string>());
    for (const auto& word : file.at("no_verbs")) verbs_.erase(word.get<std::string>());
    for (const auto& word : file.at("questions")) questions_.insert(word.get<std::string>());
    for (const auto& word : file.at("no_adverbs")) no_adverbs_.insert(word.get<std::string>());
    for (const auto& [word, entry] : file.at("states").items()) {
      StateWord& state = states_[word];
      state.wanted = frame_named(entry.value("wanted", ""));
      state.complaint = frame_named(entry.value("complaint", ""));
      state.opposite = entry.value("opposite", "");
    }
    for (const auto& [word, command] : file.at("wishes").items())
      wishes_[word] = split_words(command.get_ref<const std::string&>());
    for (const auto& rule : file.at("rewrites")) {
      Rewrite rewrite{split_words(rule.at(0).get_ref<const std::string&>()),
                      split_words(rule.at(1).get_ref<const std::string&>())};
      if (rewrite.from.empty())
        return fail(Outcome::kInvalidRequest, name + ": 'rewrites' has an empty phrase");
      rewrites_[rewrite.from.front()].push_back(std::move(rewrite));
    }
    degrees = file.value("degrees", degrees);  // older models have none
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  collect_vocabulary();
  add_degrees(degrees);
  for (auto& [first, list] : rewrites_)
    std::stable_sort(list.begin(), list.end(),
                     [](const Rewrite& a, const Rewrite& b) { return a.from.size() > b.from.size(); });
  return {};
}

Expected<void> Language::add_other_words(std::string_view text, const std::string& name) {
  try {
    const json file = json::parse(text);
    for (const auto& word : file.at("real_words")) real_words_.insert(word.get<std::string>());
    for (const auto& [word, other] : file.at("synonyms").items())
      if (!known(word) && known(other.get_ref<const std::string&>()))
        synonyms_[word] = other.get<std::string>();
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  return {};
}

Expected<void> Language::add_kinds(std::string_view text, const std::string& name) {
  try {
    const json file = json::parse(text);
    for (const auto& [kind, words] : file.at("kinds").items())
      for (const auto& word : words) kinds_.try_emplace(word.get<std::string>(), kind);
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  return {};
}

std::string Language::kind_of(const std::string& word) const {
  for (const std::string& form : {word, singular(word)})
    if (const auto it = kinds_.find(form); it != kinds_.end()) return it->second;
  return {};
}

std::string Language::verb_base(const std::string& word) const {
  if (verbs_.contains(word)) return word;
  if (const auto it = inflected_.find(word); it != inflected_.end()) return it->second;
  const auto known_verb = [&](const std::string& stem) { return stem.size() > 1 && verbs_.contains(stem); };
  for (const std::string_view ending : {"ing", "ed", "d", "es", "s"}) {
    if (rewrites_.empty() || !word.ends_with(ending) || word.size() < ending.size() + 2) continue;
    const std::string stem = word.substr(0, word.size() - ending.size());
    if (known_verb(stem)) return stem;
    if (ending == "ing" || ending == "ed") {
      if (known_verb(stem + "e")) return stem + "e";
      if (stem.size() > 2 && stem.back() == stem[stem.size() - 2] &&
          known_verb(stem.substr(0, stem.size() - 1)))
        return stem.substr(0, stem.size() - 1);
    }
    if (ending == "ed" && stem.ends_with("i") && known_verb(stem.substr(0, stem.size() - 1) + "y"))
      return stem.substr(0, stem.size() - 1) + "y";
  }
  return {};
}

Frame Language::verb(const std::string& word) const {
  const auto it = verbs_.find(verb_base(word));
  return it == verbs_.end() ? Frame::kNone : it->second;
}

bool Language::participle(const std::string& word) const {
  const std::string base = verb_base(word);
  return !base.empty() && base != word && !(word == base + "s" || word == base + "es");
}

bool Language::adverb(const std::string& word) const {
  return word.size() > 4 && word.ends_with("ly") && !no_adverbs_.contains(word) &&
         !lexicon_->is_word_of_name(word);
}

bool Language::names_something(const std::string& word) const {
  return verbs_.contains(word) || lexicon_->is_name(word) || lexicon_->is_name(singular(word));
}

bool Language::small_word(const std::string& word) const {
  static constexpr std::array kSmall = {"the"sv, "on"sv, "off"sv, "in"sv,     "into"sv, "it"sv, "to"sv,
                                        "up"sv,  "my"sv, "and"sv, "please"sv, "onto"sv, "me"sv};
  return one_of(word, kSmall);
}

bool Language::joins(const std::string& word) const {
  static constexpr std::array kJoins = {"and"sv,  ","sv,    "then"sv,       "or"sv,
                                        "but"sv,  "also"sv, "afterwards"sv, "afterward"sv,
                                        "plus"sv, "next"sv, "finally"sv,    "lastly"sv};
  return one_of(word, kJoins);
}

bool Language::copula(const std::string& word) const {
  static constexpr std::array kCopulas = {
      "is"sv,   "are"sv,    "was"sv,    "were"sv, "be"sv,     "been"sv,    "being"sv, "am"sv,    "has"sv,
      "have"sv, "had"sv,    "gone"sv,   "went"sv, "got"sv,    "get"sv,     "look"sv,  "feel"sv,  "seem"sv,
      "does"sv, "do"sv,     "did"sv,    "goe"sv,  "belong"sv, "becomes"sv, "will"sv,  "would"sv, "could"sv,
      "stay"sv, "remain"sv, "should"sv, "must"sv, "need"sv,   "ought"sv};
  return one_of(word, kCopulas);
}

bool Language::time_unit(const std::string& word) const {
  static constexpr std::array kUnits = {"second"sv, "minute"sv, "hour"sv, "moment"sv, "while"sv,
                                        "time"sv,   "min"sv,    "sec"sv,  "bit"sv,    "now"sv};
  return one_of(word, kUnits);
}

bool Language::holds_things(const std::string& phrase) const {
  static constexpr std::array kVessels = {
      "mug"sv,    "cup"sv,     "glass"sv,    "long cup"sv,   "bowl"sv,       "plate"sv,
      "kettle"sv, "pot"sv,     "tall cup"sv, "coffee cup"sv, "coffee mug"sv, "saucepan"sv,
      "pan"sv,    "tumbler"sv, "dish"sv,     "container"sv,  "vessel"sv};
  return one_of(phrase, kVessels);
}

bool Language::side_or_part(const std::string& phrase) const {
  static constexpr std::array kParts = {"door"sv,   "left door"sv, "right door"sv, "side"sv,   "knob"sv,
                                        "button"sv, "top"sv,       "burner"sv,     "handle"sv, "screen"sv,
                                        "volume"sv, "sound"sv,     "channel"sv,    "end"sv};
  return one_of(phrase, kParts);
}

bool Language::tv_word(const std::string& phrase) const {
  return phrase == "channel" || phrase == "volume" || phrase == "sound";
}

bool Language::keeps_its_s(const std::string& word) const {
  return (fillers_.contains(word) || verbs_.contains(word) || copula(word) || states_.contains(word) ||
          inflected_.contains(word)) &&
         !lexicon_->is_name(singular(word)) && !verbs_.contains(singular(word));
}

Frame Language::wanted_by_state(const std::string& word) const {
  const auto it = states_.find(word);
  return it == states_.end() ? Frame::kNone : it->second.wanted;
}

Frame Language::complaint(const std::string& word) const {
  const auto it = states_.find(word);
  return it == states_.end() ? Frame::kNone : it->second.complaint;
}

std::string Language::opposite_state(const std::string& word) const {
  const auto it = states_.find(word);
  return it == states_.end() ? std::string() : it->second.opposite;
}

const std::vector<std::string>* Language::wish(const std::string& word) const {
  const auto it = wishes_.find(word);
  return it == wishes_.end() ? nullptr : &it->second;
}

std::vector<std::string> Language::rewrite(std::vector<std::string> words, std::size_t most) const {
  if (rewrites_.empty()) return words;
  int left = kMostRewrites;
  for (std::size_t i = 0; i < words.size();) {
    const auto list = rewrites_.find(words[i]);
    const Rewrite* fits = nullptr;
    if (list != rewrites_.end())
      for (const Rewrite& rule : list->second)
        if (fits == nullptr && i + rule.from.size() <= words.size() &&
            std::equal(rule.from.begin(), rule.from.end(), words.begin() + static_cast<long>(i)))
          fits = &rule;
    if (fits == nullptr || left-- <= 0 || words.size() + fits->to.size() > most) {
      ++i;
      continue;
    }
    const auto at = words.erase(words.begin() + static_cast<long>(i),
                                words.begin() + static_cast<long>(i + fits->from.size()));
    words.insert(at, fits->to.begin(), fits->to.end());
    i = i < 4 ? 0 : i - 4;  // what was just written may be part of a longer phrase
  }
  return words;
}

Symbol Language::content(const std::string& phrase) const {
  const auto it = contents_.find(phrase);
  return it == contents_.end() ? Symbol{symbol::kNone} : it->second;
}

bool Language::known(const std::string& word) const {
  return word == "." || word == "," || (!rewrites_.empty() && (verb(word) != Frame::kNone || adverb(word))) ||
         std::binary_search(vocabulary_.begin(), vocabulary_.end(), word) ||
         std::binary_search(vocabulary_.begin(), vocabulary_.end(), singular(word)) || seen_.contains(word) ||
         seen_.contains(singular(word)) ||
         lexicon_->is_word_of_name(singular(word));  // names learned from this world
}

const std::string& Language::synonym(const std::string& word) const {
  const auto it = synonyms_.find(word);
  return it == synonyms_.end() ? word : it->second;
}

std::string Language::correct(const std::string& word) const {
  if (known(word) || synonyms_.contains(word) || real_word(word) || real_word(singular(word)) ||
      word.size() < 3)
    return word;
  const std::string stem = singular(word);
  const int allowed = word.size() >= 8 ? 2 : 1;
  int best = allowed + 1;
  std::string choice;
  for (const std::string& candidate : vocabulary_) {
    if (candidate.size() < 3) continue;
    int distance =
        std::min(spelling_distance(word, candidate, allowed), spelling_distance(stem, candidate, allowed));
    // Three letters hold little: only swapped neighbours count as a slip there.
    if (word.size() == 3) {
      std::string a = word, b = candidate;
      std::sort(a.begin(), a.end()), std::sort(b.begin(), b.end());
      const bool lost = !rewrites_.empty() && candidate.size() == 4 && candidate.front() == word.front() &&
                        meaningful(candidate);  // "grb", "fil"
      if (a != b && !lost) distance = allowed + 1;
    }
    if (distance > allowed) continue;
    // People rarely miss the first letter; and words that name or do something matter most.
    // A letter swapped, lost or doubled is likelier than another letter.
    const bool replaced = candidate.size() == word.size() && [&] {
      std::string a = word, b = candidate;
      std::sort(a.begin(), a.end()), std::sort(b.begin(), b.end());
      return a != b;
    }();
    const int cost = 8 * distance + (candidate.front() == word.front() ? 0 : 4) + (replaced ? 3 : 0) +
                     (filler(candidate) ? 1 : 0);
    if (choice.empty() || cost < best) best = cost, choice = candidate;
  }
  return choice.empty() ? word : choice;
}

std::string Language::unknown_word(const std::string& word) const {
  if (known(word))
    return "it is not clear what \"" + word + "\" asks for; say for example \"bring me the mug\"";
  const std::string near = nearest(word);
  return "\"" + word + "\" is unknown; " +
         (near.empty() ? "say it with the names of things and places that are here"
                       : "the nearest known word is \"" + near + "\"");
}

std::string Language::nearest(const std::string& word) const {
  // Letters say nothing of an English word that is merely unknown here.
  if (real_word(word) || !kind_of(word).empty()) return {};
  int best = 1 + static_cast<int>(word.size() + 1) / 3;
  std::string choice;
  for (const std::string& candidate : vocabulary_) {
    if (verb(candidate) == Frame::kNone && !lexicon_->is_word_of_name(singular(candidate))) continue;
    const int distance = spelling_distance(word, candidate, best);
    if (distance < best) best = distance, choice = candidate;
  }
  return choice;
}

}  // namespace goalnet::inference

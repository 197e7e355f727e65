#include "components/goalnet/language/language.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>

namespace goalnet::inference {
namespace {

using nlohmann::json;

constexpr std::array<std::pair<std::string_view, Frame>, 25> kFrames = {{
    {"go", Frame::kGo},         {"take", Frame::kTake},       {"place", Frame::kPlace},
    {"bring", Frame::kBring},   {"discard", Frame::kDiscard}, {"fill", Frame::kFill},
    {"pour", Frame::kPour},     {"empty", Frame::kEmpty},     {"turn", Frame::kTurn},
    {"start", Frame::kStart},   {"stop", Frame::kStop},       {"open", Frame::kOpen},
    {"close", Frame::kClose},   {"wash", Frame::kWash},       {"heat", Frame::kHeat},
    {"boil", Frame::kBoil},     {"add", Frame::kAdd},         {"squeeze", Frame::kSqueeze},
    {"scoop", Frame::kScoop},   {"insert", Frame::kInsert},   {"release", Frame::kRelease},
    {"change", Frame::kChange}, {"mute", Frame::kMute},       {"raise", Frame::kRaise},
    {"lower", Frame::kLower},
}};

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
      const auto frame =
          std::find_if(kFrames.begin(), kFrames.end(),
                       [&, n = std::string_view(frame_name)](const auto& f) { return f.first == n; });
      if (frame == kFrames.end())
        return fail(Outcome::kInvalidRequest, name + ": 'verbs' has the unknown frame '" + frame_name + "'");
      // The first frame that lists a word keeps it.
      for (const auto& word : words) language.verbs_.try_emplace(word.get<std::string>(), frame->second);
    }
    for (const auto& [content, phrases] : file.at("contents").items())
      for (const auto& phrase : phrases)
        language.contents_[phrase.get<std::string>()] = symbols.intern(content);
    for (const auto& word : file.at("fillers")) language.fillers_.insert(word.get<std::string>());
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  for (const auto& [word, frame] : language.verbs_) language.vocabulary_.push_back(word);
  for (const auto& [word, count] : lexicon.words()) language.vocabulary_.push_back(word);
  for (const std::string& word : language.fillers_) language.vocabulary_.push_back(word);
  std::sort(language.vocabulary_.begin(), language.vocabulary_.end());
  const auto end = std::unique(language.vocabulary_.begin(), language.vocabulary_.end());
  language.vocabulary_.erase(end, language.vocabulary_.end());
  return language;
}

Frame Language::verb(const std::string& word) const {
  const auto it = verbs_.find(word);
  return it == verbs_.end() ? Frame::kNone : it->second;
}

Symbol Language::content(const std::string& phrase) const {
  const auto it = contents_.find(phrase);
  return it == contents_.end() ? Symbol{symbol::kNone} : it->second;
}

bool Language::known(const std::string& word) const {
  return word == "." || word == "," || std::binary_search(vocabulary_.begin(), vocabulary_.end(), word) ||
         std::binary_search(vocabulary_.begin(), vocabulary_.end(), singular(word)) || seen_.contains(word) ||
         seen_.contains(singular(word)) ||
         lexicon_->is_word_of_name(singular(word));  // names learned from this world
}

void Language::add_synonym(const std::string& word, const std::string& known_word) {
  if (!known(word) && known(known_word)) synonyms_[word] = known_word;
}

const std::string& Language::synonym(const std::string& word) const {
  const auto it = synonyms_.find(word);
  return it == synonyms_.end() ? word : it->second;
}

std::string Language::correct(const std::string& word) const {
  if (known(word) || synonyms_.contains(word) || word.size() < 3) return word;
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
      if (a != b) distance = allowed + 1;
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
  const std::string near = nearest(word);
  return "\"" + word + "\" is unknown; " +
         (near.empty() ? "say it with the names of things and places that are here"
                       : "the nearest known word is \"" + near + "\"");
}

std::string Language::nearest(const std::string& word) const {
  int best = 1 + static_cast<int>(word.size()) / 2;
  std::string choice;
  for (const std::string& candidate : vocabulary_) {
    if (filler(candidate)) continue;
    const int distance = spelling_distance(word, candidate, best);
    if (distance < best) best = distance, choice = candidate;
  }
  return choice;
}

}  // namespace goalnet::inference

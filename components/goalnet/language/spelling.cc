// Typing errors, and what is nearest to a word that is not known.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "components/goalnet/language/language.h"

namespace goalnet::inference {
namespace {

bool same_letters(std::string a, std::string b) {
  std::sort(a.begin(), a.end()), std::sort(b.begin(), b.end());
  return a == b;
}

std::string without_doubles(std::string word) {
  word.erase(std::unique(word.begin(), word.end()), word.end());
  return word;
}

bool is_particle(const std::string& word) {
  return word == "back" || word == "over" || word == "away" || word == "down" || word == "with" ||
         word == "from" || word == "into" || word == "onto";
}

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

std::vector<std::string> Language::within_a_slip(const std::string& word) const {
  const std::string stem = singular(word);
  const int allowed = word.size() >= 8 ? 2 : 1;
  std::vector<std::pair<int, std::string>> found;
  for (const std::string& candidate : vocabulary_) {
    if (candidate.size() < 3) continue;
    int distance =
        std::min(spelling_distance(word, candidate, allowed), spelling_distance(stem, candidate, allowed));
    // Three letters hold little: only swapped neighbours count as a slip there.
    if (word.size() == 3) {
      const bool lost = !rewrites_.empty() && candidate.size() == 4 && candidate.front() == word.front() &&
                        (meaningful(candidate) || (hears_people_ && is_particle(candidate)));  // "grb", "bak"
      if (!same_letters(word, candidate) && !lost) distance = allowed + 1;
    }
    if (distance > allowed) continue;
    // People rarely miss the first letter; and words that name or do something matter most.
    // A letter swapped, lost or doubled is likelier than another letter.
    const bool replaced = candidate.size() == word.size() && !same_letters(word, candidate);
    const bool doubled = !rewrites_.empty() && without_doubles(word) == without_doubles(candidate);  // "glas"
    found.emplace_back(8 * distance - (doubled ? 3 : 0) + (candidate.front() == word.front() ? 0 : 4) +
                           (replaced ? 3 : 0) + (filler(candidate) ? 1 : 0) -
                           (hears_people_ && candidate.size() > word.size() ? 1 : 0),
                       candidate);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> words;
  for (auto& [cost, candidate] : found) words.push_back(std::move(candidate));
  return words;
}

// "armch" -> "armchair": the only name that begins so; the word itself where there is none.
std::string Language::written_out(const std::string& word) const {
  constexpr std::size_t kShortest = 4;
  std::string whole;
  if (word.size() < kShortest) return word;
  for (auto it = std::lower_bound(vocabulary_.begin(), vocabulary_.end(), word);
       it != vocabulary_.end() && it->starts_with(word); ++it) {
    if (!names_thing(*it) || (!whole.empty() && it->starts_with(whole))) continue;  // "armchairs"
    if (!whole.empty()) return word;
    whole = *it;
  }
  return whole.empty() ? word : whole;
}

bool Language::may_be_a_slip(const std::string& word) const {
  return word.size() >= 3 && !known(word) && !synonyms_.contains(word) && !real_word(word) &&
         !real_word(singular(word));
}

std::string Language::correct(const std::string& word) const {
  if (!may_be_a_slip(word)) return word;
  const std::vector<std::string> choice = within_a_slip(word);
  if (choice.empty() && hears_people_) return written_out(word);
  return choice.empty() ? word : choice.front();
}

std::vector<std::string> Language::corrections(const std::string& word) const {
  constexpr std::size_t kMost = 4;
  std::vector<std::string> choice;
  if (const auto it = mistaken_.find(word); it != mistaken_.end()) choice = it->second;
  if (choice.empty() && may_be_a_slip(word)) choice = within_a_slip(word);
  if (choice.size() > kMost) choice.resize(kMost);
  return choice;
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

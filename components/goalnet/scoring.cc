#include "components/goalnet/scoring.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>

namespace goalnet::inference {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; }

std::set<std::string> scored_facts(const FactSet& facts) {
  std::set<std::string> result;
  for (const Predicate& fact : facts) {
    if (fact.object.empty()) continue;  // properties are not scored
    std::string text = to_string(fact);
    std::transform(text.begin(), text.end(), text.begin(), lower);
    result.insert(std::move(text));
  }
  return result;
}

std::set<std::string> minus(const std::set<std::string>& left, const std::set<std::string>& right) {
  std::set<std::string> result;
  std::set_difference(left.begin(), left.end(), right.begin(), right.end(),
                      std::inserter(result, result.end()));
  return result;
}

std::size_t common(const std::set<std::string>& left, const std::set<std::string>& right) {
  return static_cast<std::size_t>(
      std::count_if(left.begin(), left.end(), [&](const std::string& text) { return right.contains(text); }));
}

std::vector<std::string> action_words(const std::string& action) {
  std::string text;
  for (const char c : action)
    if (c != '\'') text.push_back(c == '(' || c == ')' || c == ',' ? ' ' : lower(c));
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string canonical_action(const std::string& action) {
  std::string text;
  for (const std::string& word : action_words(action)) text += (text.empty() ? "" : " ") + word;
  return text;
}

// The spelling that the published evaluation compares: every keep but the sink's is an "on".
std::string published_action(const std::string& action) {
  const std::vector<std::string> words = action_words(action);
  if (words.size() >= 4 && words[0] == "keep")
    return words.back() == "sink" ? "keep_on_sink_" + words[1] : "on_keep_" + words[1] + "_" + words[3];
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "_") + word;
  return text;
}

template <class Spell>
double similarity(std::span<const std::string> left, std::span<const std::string> right, Spell spell) {
  std::vector<std::string> a, b;
  for (const std::string& action : left) a.push_back(spell(action));
  for (const std::string& action : right) b.push_back(spell(action));
  return edit_similarity(a, b);
}

}  // namespace

Scores& Scores::operator+=(const Scores& other) {
  sji += other.sji, f1 += other.f1, ied += other.ied, grr += other.grr;
  grr_formula += other.grr_formula, exact += other.exact, ied_canonical += other.ied_canonical;
  return *this;
}

Scores Scores::operator/(double n) const {
  return {sji / n, f1 / n, ied / n, grr / n, grr_formula / n, exact / n, ied_canonical / n};
}

double edit_similarity(std::span<const std::string> left, std::span<const std::string> right) {
  if (left.empty() || right.empty()) return left.empty() && right.empty() ? 1.0 : 0.0;
  std::vector<std::size_t> row(right.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 1; i <= left.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const std::size_t substituted = diagonal + (left[i - 1] == right[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return 1.0 - static_cast<double>(row.back()) / static_cast<double>(std::max(left.size(), right.size()));
}

Scores score_run(const FactSet& start, const FactSet& demonstrated_end,
                 std::span<const std::string> demonstrated, const FactSet& run_end,
                 std::span<const std::string> run) {
  const auto before = scored_facts(start), goal = scored_facts(demonstrated_end), end = scored_facts(run_end);
  const auto want_added = minus(goal, before), want_removed = minus(before, goal);
  const auto got_added = minus(end, before), got_removed = minus(before, end);
  const double hit = static_cast<double>(common(want_added, got_added) + common(want_removed, got_removed));
  const double wanted = static_cast<double>(want_added.size() + want_removed.size());
  const double got = static_cast<double>(got_added.size() + got_removed.size());
  const double all = wanted + got - hit;
  Scores scores;
  if (all > 0) scores.sji = hit / all;
  const double precision = got > 0 ? hit / got : 0, recall = wanted > 0 ? hit / wanted : 0;
  if (precision + recall > 0) scores.f1 = 2 * precision * recall / (precision + recall);
  scores.ied = run.empty() || demonstrated.empty() ? 0 : similarity(run, demonstrated, published_action);
  scores.ied_canonical = similarity(run, demonstrated, canonical_action);
  scores.grr = hit == wanted ? 1 : 0;
  scores.grr_formula = hit == got ? 1 : 0;
  scores.exact = hit == wanted && hit == got ? 1 : 0;
  return scores;
}

}  // namespace goalnet::inference

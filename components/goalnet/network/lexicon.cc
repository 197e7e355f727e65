#include "components/goalnet/network/lexicon.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

namespace goalnet::inference::network {
namespace {

constexpr std::size_t kMaxWords = 20000;  // far above any vocabulary of this project; bounds a hostile file

TextMap ids_of(const std::vector<std::string>& names) {
  TextMap ids;
  for (const std::string& name : names) ids.emplace(name, static_cast<int>(ids.size()));
  return ids;
}

int find(const TextMap& ids, std::string_view name) {
  const auto found = ids.find(name);
  return found == ids.end() ? -1 : found->second;
}

}  // namespace

SplitName split_name(std::string_view object) {
  SplitName result;
  std::string_view stem = object;
  const std::size_t bar = object.rfind('_');
  if (bar != std::string_view::npos && bar + 1 < object.size() &&
      std::all_of(object.begin() + static_cast<std::ptrdiff_t>(bar) + 1, object.end(),
                  [](unsigned char c) { return std::isdigit(c); })) {
    for (const char c : object.substr(bar + 1))
      result.instance = std::min(result.instance * 10 + (c - '0'), 1000);
    stem = object.substr(0, bar);
  }
  result.class_name = stem;
  std::string word;
  const auto finish = [&] {
    if (!word.empty()) result.words.push_back(word);
    word.clear();
  };
  for (const char raw : stem) {
    const auto c = static_cast<unsigned char>(raw);
    if (std::isupper(c) || !std::isalpha(c)) finish();
    if (std::isalpha(c)) word.push_back(static_cast<char>(std::tolower(c)));
  }
  finish();
  return result;
}

Lexicon::Lexicon(std::vector<std::string> words, std::vector<std::string> classes,
                 std::map<std::string, std::map<std::string, float>> senses)
    : words_(std::move(words)),
      classes_(std::move(classes)),
      word_ids_(ids_of(words_)),
      class_ids_(ids_of(classes_)),
      senses_(words_.size()) {
  for (const auto& [word, meanings] : senses) {
    const int id = find(word_ids_, word);
    if (id < 0) continue;
    for (const auto& [name, probability] : meanings) {
      const int class_id = find(class_ids_, name);
      if (class_id >= 0) senses_[static_cast<std::size_t>(id)].push_back({class_id, probability});
    }
  }
}

int Lexicon::word(std::string_view text) const { return find(word_ids_, text); }
int Lexicon::class_of(std::string_view name) const { return find(class_ids_, name); }

std::string Lexicon::to_json() const {
  nlohmann::json json = {{"words", words_}, {"classes", classes_}, {"senses", nlohmann::json::object()}};
  for (std::size_t i = 0; i < words_.size(); ++i) {
    for (const WordSense& sense : senses_[i]) {
      json["senses"][words_[i]][classes_[static_cast<std::size_t>(sense.class_id)]] = sense.probability;
    }
  }
  return json.dump();
}

Expected<Lexicon> Lexicon::parse(const std::string& text) {
  const auto refuse = [](const std::string& why) {
    return fail(Outcome::kInvalidRequest, "the model's lexicon " + why);
  };
  try {
    const auto json = nlohmann::json::parse(text);
    auto words = json.at("words").get<std::vector<std::string>>();
    auto classes = json.at("classes").get<std::vector<std::string>>();
    auto senses = json.at("senses").get<std::map<std::string, std::map<std::string, float>>>();
    if (words.size() > kMaxWords || classes.size() > kMaxWords) return refuse("holds too many words");
    for (const auto* names : {&words, &classes}) {
      if (ids_of(*names).size() != names->size()) return refuse("holds a word twice");
    }
    for (const auto& [word, meanings] : senses) {
      for (const auto& [name, probability] : meanings) {
        if (!(probability >= 0 && probability <= 1)) return refuse("has a probability outside 0..1");
      }
    }
    return Lexicon(std::move(words), std::move(classes), std::move(senses));
  } catch (const nlohmann::json::exception& error) {
    return refuse(std::string("cannot be read: ") + error.what());
  }
}

}  // namespace goalnet::inference::network

#include "components/goalnet/lexicon.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace goalnet::inference {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxClasses = 4096;

template <class Range, class Value>
bool contains(const Range& range, const Value& value) {
  return std::find(range.begin(), range.end(), value) != range.end();
}

// The singular of every word of a phrase.
std::string normal_phrase(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string phrase;
  for (std::string word; words >> word;) phrase += (phrase.empty() ? "" : " ") + singular(word);
  return phrase;
}

void set_kinds(ObjectClass& c) {
  const auto is = [&](const char* kind) { return contains(c.kinds, kind); };
  c.movable = is("movable"), c.vessel = is("vessel"), c.place = is("place"), c.food = is("food");
  c.drink = is("drink"), c.dish = is("dish"), c.utensil = is("utensil");
}

}  // namespace

bool ObjectClass::is(std::string_view kind) const { return contains(kinds, kind); }

std::string singular(const std::string& word) {
  const auto ends = [&](std::string_view tail) { return word.size() > tail.size() && word.ends_with(tail); };
  constexpr std::array<std::string_view, 14> kNoPlural = {"chips", "is",     "its",   "this", "has",
                                                          "glass", "dish",   "dress", "us",   "yes",
                                                          "gas",   "tennis", "less",  "cs"};
  if (word == "chips") return "chip";
  if (contains(kNoPlural, word) || word.size() < 4) return word == "cds" ? "cd" : word;
  if (word == "shelves") return "shelf";
  if (word == "knives") return "knife";
  if (word == "couches" || word == "coaches" || word == "dishes" || word == "boxes" || word == "glasses" ||
      word == "switches" || word == "dresses" || word == "benches")
    return word.substr(0, word.size() - 2);
  if (ends("ss") || ends("us")) return word;
  if (ends("ies") && word != "movies" && word != "cookies") return word.substr(0, word.size() - 3) + "y";
  if (ends("s")) return word.substr(0, word.size() - 1);
  return word;
}

bool is_plural(const std::string& word) { return singular(word) != word; }

std::string spoken_name(std::string_view object) {
  std::string text;
  for (std::size_t i = 0; i < object.size(); ++i) {
    const char c = object[i];
    const bool upper = c >= 'A' && c <= 'Z', digit = c >= '0' && c <= '9';
    if (c == '_' || c == '-') {
      if (!text.empty() && text.back() != ' ') text.push_back(' ');
    } else if (digit) {
      continue;  // instance numbers are no words
    } else {
      if (upper && i > 0 && object[i - 1] >= 'a' && object[i - 1] <= 'z') text.push_back(' ');
      text.push_back(upper ? static_cast<char>(c | 0x20) : c);
    }
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

void Lexicon::add_phrase(std::string_view text, ClassId id, bool exact) {
  const std::string phrase = normal_phrase(text);
  auto& list = exact ? phrases_[phrase].exact : phrases_[phrase].generic;
  if (!contains(list, id)) list.push_back(id);
  std::istringstream words(phrase);
  for (std::string word; words >> word;) ++words_[word];
}

Expected<Lexicon> Lexicon::parse(std::string_view text, const std::string& name, Symbols& symbols) {
  Lexicon lexicon;
  lexicon.source_ = std::string(text);
  try {
    const json file = json::parse(text);
    for (const auto& [class_name, entry] : file.at("classes").items()) {
      if (lexicon.classes_.size() >= kMaxClasses)
        return fail(Outcome::kInvalidRequest,
                    name + ": more than " + std::to_string(kMaxClasses) + " classes");
      const ClassId id = static_cast<ClassId>(lexicon.classes_.size());
      ObjectClass object_class{.name = class_name,
                               .kinds = entry.at("kinds").get<std::vector<std::string>>()};
      set_kinds(object_class);
      lexicon.classes_.push_back(std::move(object_class));
      lexicon.class_by_name_[class_name] = id;
      for (const auto& object : entry.at("objects"))
        lexicon.class_of_[symbols.intern(object.get_ref<const std::string&>())] = id;
      for (const auto& phrase : entry.at("names"))
        lexicon.add_phrase(phrase.get_ref<const std::string&>(), id, true);
      for (const auto& phrase : entry.at("also"))
        lexicon.add_phrase(phrase.get_ref<const std::string&>(), id, false);
    }
    for (const auto& [object, phrases] : file.at("objects").items())
      for (const auto& item : phrases) {
        const std::string phrase = normal_phrase(item.get_ref<const std::string&>());
        lexicon.phrases_[phrase].objects.push_back(symbols.intern(object));
        std::istringstream words(phrase);
        for (std::string word; words >> word;) ++lexicon.words_[word];
      }
    for (const auto& [room, objects] : file.at("rooms").items())
      lexicon.rooms_.push_back(objects.get<std::vector<std::string>>());
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  return lexicon;
}

Expected<Lexicon> Lexicon::load(const std::filesystem::path& path, Symbols& symbols) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return fail(Outcome::kInvalidRequest, path.string() + ": cannot be read");
  return parse(text.str(), path.string(), symbols);
}

Expected<void> Lexicon::add_names(std::string_view text, const std::string& name) {
  try {
    const json file = json::parse(text);
    for (const char* section : {"names", "also"}) {
      const json listed = file.value(section, json::object());
      for (const auto& [class_name, phrases] : listed.items()) {
        const auto known = class_by_name_.find(class_name);
        if (known == class_by_name_.end()) continue;
        for (const auto& phrase : phrases)
          add_phrase(phrase.get_ref<const std::string&>(), known->second,
                     section == std::string_view("names"));
      }
    }
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  return {};
}

ClassId Lexicon::class_of(Symbol object, const Symbols& symbols) {
  const auto known = class_of_.find(object);
  if (known != class_of_.end()) return known->second;
  const std::string name = spoken_name(symbols.name(object));
  const auto [it, added] = class_by_name_.try_emplace(name, static_cast<ClassId>(classes_.size()));
  if (added) {
    // The same things under another number ("Mug_7"): share the class that bears this name.
    const auto named = phrases_.find(normal_phrase(name));
    if (named != phrases_.end() && !named->second.exact.empty()) {
      it->second = named->second.exact.front();
    } else if (classes_.size() < kMaxClasses) {
      classes_.push_back(ObjectClass{.name = name, .kinds = {}});
      add_phrase(name, it->second, true);
    } else {
      it->second = 0;
    }
  }
  class_of_[object] = it->second;
  return it->second;
}

NameLevel Lexicon::names(const std::string& phrase, Symbol object, ClassId object_class) const {
  const auto it = phrases_.find(phrase);
  if (it == phrases_.end()) return NameLevel::kNone;
  if (contains(it->second.objects, object)) return NameLevel::kOwnName;
  if (contains(it->second.exact, object_class)) return NameLevel::kName;
  if (contains(it->second.generic, object_class)) return NameLevel::kGeneric;
  return NameLevel::kNone;
}

bool Lexicon::is_place_name(const std::string& phrase) const {
  const auto it = phrases_.find(phrase);
  return it != phrases_.end() && std::any_of(it->second.exact.begin(), it->second.exact.end(),
                                             [&](ClassId id) { return classes_[id].place; });
}

bool Lexicon::is_name_of(const std::string& phrase, std::string_view class_name) const {
  const auto id = class_by_name_.find(std::string(class_name));
  const auto it = phrases_.find(phrase);
  return id != class_by_name_.end() && it != phrases_.end() && contains(it->second.exact, id->second);
}

void Lexicon::complete_objects(WorldState& state) const {
  std::set<std::string> objects(state.objects.begin(), state.objects.end());
  for (const auto& room : rooms_) {
    // Objects of both rooms (Plate_1, Coke_1, Robot) say nothing; half of what is seen decides.
    const auto seen = std::count_if(room.begin(), room.end(), [&](const std::string& name) {
      return std::find(state.objects.begin(), state.objects.end(), name) != state.objects.end();
    });
    if (2 * static_cast<std::size_t>(seen) > state.objects.size()) objects.insert(room.begin(), room.end());
  }
  state.objects.assign(objects.begin(), objects.end());
}

}  // namespace goalnet::inference

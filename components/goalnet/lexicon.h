// What the project knows of words and things before any learning: classes of objects, their names, which room
// holds what (config/language/household.json; a trained model carries its copy).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/goalnet/symbols.h"

namespace goalnet::inference {

using ClassId = std::uint16_t;

struct ObjectClass {
  std::string name;                  // "long_cup"
  std::vector<std::string> kinds{};  // movable, vessel, place, device, ...
  bool movable = false, vessel = false, place = false, food = false, drink = false, dish = false,
       utensil = false;
  bool is(std::string_view kind) const;
};

// How well a phrase names an object.
enum class NameLevel : std::uint8_t {
  kNone,
  kGeneric,
  kName,
  kOwnName
};  // "dish", "plate", "chocolate syrup"

class Lexicon {
 public:
  // Fails with kInvalidRequest: `name`, and which key is wrong.
  static Expected<Lexicon> parse(std::string_view json, const std::string& name, Symbols& symbols);
  static Expected<Lexicon> load(const std::filesystem::path& path, Symbols& symbols);

  // More names of the classes: sections "names" and "also" of config/language/english.json. Classes that this
  // lexicon lacks are passed over. Fails with kInvalidRequest.
  Expected<void> add_names(std::string_view json, const std::string& name);

  // The class of an object. Objects the lexicon does not list get a class from their name ("Bottle_2" ->
  // "bottle"), added here, so that people can still name them.
  ClassId class_of(Symbol object, const Symbols& symbols);
  const ObjectClass& object_class(ClassId id) const { return classes_[id]; }
  std::size_t classes() const { return classes_.size(); }

  // How well `phrase` (normal words joined by one blank) names the object.
  NameLevel names(const std::string& phrase, Symbol object, ClassId object_class) const;
  bool is_name(const std::string& phrase) const { return phrases_.contains(phrase); }
  // Whether the phrase is a name of that class, not only a word for many kinds of things.
  bool is_name_of(const std::string& phrase, std::string_view class_name) const;
  // Whether the phrase is a name of places where things stand, as "shelf".
  bool is_place_name(const std::string& phrase) const;
  bool is_word_of_name(const std::string& word) const { return words_.contains(word); }
  const std::unordered_map<std::string, int>& words() const { return words_; }

  // A demonstration's state lists only what facts mention; this adds the things of the room(s) it plays in.
  void complete_objects(WorldState& state) const;

  const std::string& source() const { return source_; }  // the JSON text, for the model file

 private:
  struct Named {
    std::vector<ClassId> exact, generic;
    std::vector<Symbol> objects;
  };
  void add_phrase(std::string_view text, ClassId id, bool exact);

  std::string source_;
  std::vector<ObjectClass> classes_;
  std::unordered_map<Symbol, ClassId> class_of_;
  std::unordered_map<std::string, ClassId> class_by_name_;
  std::unordered_map<std::string, Named> phrases_;
  std::unordered_map<std::string, int> words_;  // word of any name -> in how many names
  std::vector<std::vector<std::string>> rooms_;
};

// "Pillows" -> "pillow", "shelves" -> "shelf", "glasses" -> "glass". Words that only look like plurals stay.
std::string singular(const std::string& word);
bool is_plural(const std::string& word);
// "LongCup_1" -> "long cup"; "GarbageBag_1" -> "garbage bag".
std::string spoken_name(std::string_view object);

}  // namespace goalnet::inference

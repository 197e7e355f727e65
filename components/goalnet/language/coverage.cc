#include "components/goalnet/language/coverage.h"

#include <algorithm>

#include "components/goalnet/language/symbol_list.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

using namespace symbol;
using namespace word_group;

using Objects = std::vector<Symbol>;

bool any_in(const Objects& objects, const Objects& used) {
  return std::any_of(objects.begin(), objects.end(), [&](Symbol object) { return contains(used, object); });
}

// All names in the phrase and in what tells it apart.
void names_of(const NounPhrase& phrase, std::vector<std::string>& names) {
  for (const std::string& name : {phrase.phrase, phrase.content, phrase.modifier})
    if (!name.empty()) names.push_back(name);
  for (const NounPhrase& place : phrase.at) names_of(place, names);
}

class Coverage {
 public:
  Coverage(const ReadMessage& message, const Language& language, const Lexicon& lexicon,
           const Resolver& resolver, const SymState& start)
      : message_(message), language_(language), lexicon_(lexicon), resolver_(resolver), start_(start) {
    for (const SymAction& action : message.actions) used_.push_back(action.x), used_.push_back(action.y);
    if (contains(used_, kSinkKnob)) used_.push_back(kSink);  // what stands under the tap is filled with it
    concerned_ = used_;
    for (const Symbol object : used_) {
      concerned_.push_back(resolver.place_of(object, start));
      if (object >= kStoveKnob_1 && object <= kStoveKnob_4)
        concerned_.push_back(kStove), concerned_.push_back(kStoveFire_1 + (object - kStoveKnob_1));
      if (object == kFridgeLeftDoor || object == kFridgeRightDoor || object == kFridgeButton)
        concerned_.push_back(kFridge);
      if (object == kMicrowaveButton) concerned_.push_back(kMicrowave);
    }
  }

  // What a command names and does nothing with.
  Symbol of_command(const ReadCommand& command) const {
    const Clause& clause = *command.clause;
    static constexpr std::array kDevices = {Frame::kTurn, Frame::kStart, Frame::kStop};  // "stop the kettle"
    if (!clause.condition.empty() ||
        std::find(kDevices.begin(), kDevices.end(), clause.frame) != kDevices.end())
      return kNone;
    // What does nothing may be so already, but nobody has what is neither held nor brought.
    const bool fetches = (clause.frame == Frame::kTake || clause.frame == Frame::kBring) &&
                         clause.first(Role::kDestination) == nullptr;
    if (command.begin == command.end && !fetches) return kNone;
    for (const NounPhrase& phrase : clause.phrases) {
      if (phrase.role == Role::kExcept || phrase.role == Role::kSource || phrase.alternative ||
          phrase.negated)
        continue;
      if (phrase.role == Role::kDestination && phrase.where == Where::kNear) continue;  // tells where
      const Objects meant = carried(phrase.phrase);
      if (meant.empty() || any_in(meant, used_) ||
          std::any_of(meant.begin(), meant.end(), [&](Symbol object) {
            return start_.holds(object) || contains(used_, resolver_.place_of(object, start_));
          }))
        continue;
      // "drizzle syrup on the ice cream": on what holds some
      const Symbol content = language_.content(phrase.phrase);
      if (content != kNone &&
          std::any_of(used_.begin(), used_.end(), [&](Symbol object) { return start_.is(object, content); }))
        continue;
      return meant.front();
    }
    return kNone;
  }

  // What is named in words that became no part of any clause.
  Symbol of_words() const {
    std::vector<std::string> read;
    for (const Clause& clause : message_.sentence.clauses) {
      for (const NounPhrase& phrase : clause.phrases) names_of(phrase, read);
      for (const Clause& condition : clause.condition)
        for (const NounPhrase& phrase : condition.phrases) names_of(phrase, read);
    }
    Objects spoken;
    for (const std::string& name : read)
      for (const Symbol object : carried(name)) spoken.push_back(object);
    const std::vector<std::string>& text = message_.words.text;
    const NounPhraseReader reader(message_.words, language_, lexicon_);
    static constexpr std::array kElse = {"not"sv, "no"sv, "instead"sv, "or"sv, "for"sv, "like"sv};
    bool beside = false;  // says when, why, what for or what not
    for (std::size_t i = 0, length; i < text.size(); i += length) {
      length = std::max<std::size_t>(reader.name_length(i), 1);
      if (text[i] == "." || text[i] == ",") beside = false;
      const bool goes_on = text[i] == "so" && i + 1 < text.size() && !one_of(text[i + 1], kSubjects);
      beside = beside || (one_of(text[i], kSubordinate) && !goes_on) || one_of(text[i], kElse) ||
               one_of(text[i], kTurns);
      const bool verb =
          length == 1 && language_.verb(text[i]) != Frame::kNone;  // "lay", also a name of crisps
      const bool which = i + length < text.size() && text[i + length] == "one";  // "the vanilla one"
      if (beside || verb || which || reader.name_length(i) == 0) continue;
      std::string name = text[i];
      for (std::size_t k = 1; k < length; ++k) name += " " + text[i + k];
      const Objects meant = carried(name);
      if (!meant.empty() && !any_in(meant, used_) && !any_in(meant, spoken)) return meant.front();
      const Objects there = fixed(name);
      if (!there.empty() && !any_in(there, concerned_) &&
          std::find(read.begin(), read.end(), name) == read.end())
        return there.front();
    }
    return kNone;
  }

 private:
  // What a name means of furniture and devices.
  Objects fixed(const std::string& name) const {
    Objects result;
    for (const SeenObject& object : resolver_.objects())
      if (lexicon_.object_class(object.class_id).place &&
          lexicon_.names(name, object.symbol, object.class_id) >= NameLevel::kName)
        result.push_back(object.symbol);
    return result;
  }
  // What a name means of the things that can be carried.
  Objects carried(const std::string& name) const {
    Objects result;
    for (const SeenObject& object : resolver_.objects())
      if (const ObjectClass& c = lexicon_.object_class(object.class_id);
          c.movable && !c.place && lexicon_.names(name, object.symbol, object.class_id) >= NameLevel::kName)
        result.push_back(object.symbol);
    return result;
  }

  const ReadMessage& message_;
  const Language& language_;
  const Lexicon& lexicon_;
  const Resolver& resolver_;
  const SymState& start_;
  Objects used_, concerned_;  // concerned: also where the used things stand, what the used knobs turn
};

}  // namespace

Symbol unused_thing(const ReadMessage& message, const Language& language, const Lexicon& lexicon,
                    const Resolver& resolver, const SymState& start) {
  const auto& text = message.words.text;
  if (std::find(text.begin(), text.end(), "correction") != text.end())
    return kNone;  // replaces what was named
  const Coverage coverage(message, language, lexicon, resolver, start);
  for (const ReadCommand& command : message.commands)
    if (const Symbol unused = coverage.of_command(command); unused != kNone) return unused;
  return coverage.of_words();
}

}  // namespace goalnet::inference

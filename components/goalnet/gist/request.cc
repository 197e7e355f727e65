#include "components/goalnet/gist/request.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace goalnet::inference::gist {
namespace {

constexpr int kBurners = 4;

// The start by classes: what is where, how things are, what is held.
struct Start {
  std::set<std::pair<std::string, std::string>> at, is;
  std::set<std::string> held;
};

Start by_class(const SymState& state, const Instruction& here, const Lexicon& lexicon,
               const Symbols& symbols) {
  Start start;
  const auto name = [&](Symbol object) { return class_name(object, here, lexicon, symbols); };
  for (const SymFact fact : state.facts()) {
    const Symbol subject = subject_of(fact), object = object_of(fact);
    switch (relation_of(fact)) {
      case Relation::kOn:
      case Relation::kIn:
        start.at.emplace(name(subject), name(object));
        break;
      case Relation::kState:
        start.is.emplace(name(subject), symbols.name(object));
        break;
      case Relation::kGrasping:
        start.held.insert(name(object));
        break;
      default:
        break;
    }
  }
  return start;
}

const char* switched(const std::string& device) {
  if (device == "tv") return "IsOn";
  if (device == "tap") return "TapIsOn";
  if (device == "microwave") return "MicrowaveIsOn";
  if (device == "fridge") return "WaterDispenserIsOpen";
  return nullptr;
}

bool is_place(const ObjectClass& c) {
  return !c.movable || c.vessel || c.place || c.dish || c.name == "garbage_bag" || c.name == "xbox";
}

class Finder {
 public:
  Finder(const Message& message, const Instruction& here, const Start& start, const Lexicon& lexicon,
         const Symbols& symbols)
      : message_(message), start_(start), lexicon_(lexicon), symbols_(symbols) {
    for (const SeenObject& object : here.objects) here_.insert(lexicon.object_class(object.class_id).name);
  }

  std::vector<Request> find() {
    for (int i = 0; i < static_cast<int>(message_.named.size()); ++i)
      for (const ClassId id : message_.named[static_cast<std::size_t>(i)].classes)
        of(i, lexicon_.object_class(id));
    if (here_.contains("tv")) of_television();
    return std::move(requests_);
  }

 private:
  Request& add(Ask ask, int thing, const std::string& thing_class, std::string what, bool holds = false) {
    requests_.push_back({.ask = ask,
                         .thing = thing,
                         .thing_class = thing_class,
                         .other_class = {},
                         .holds = holds,
                         .what = std::move(what)});
    return requests_.back();
  }
  bool is(const std::string& thing, const std::string& value) const {
    return start_.is.contains({thing, value});
  }

  void of(int i, const ObjectClass& c) {
    const std::string& name = c.name;
    if (c.movable) of_movable(i, name);
    if (c.movable) {
      add(Ask::kFillWithWater, i, name, "is " + name + " Water", is(name, "Water"));
      if (c.vessel || c.dish)
        add(Ask::kHeat, i, name, "is " + name + " temperatureHigh", is(name, "temperatureHigh"));
      if (c.vessel || c.dish) add(Ask::kEmpty, i, name, "empty " + name);
      if (c.vessel || c.dish || name == "ice_cream") of_content(i, name);
    } else {
      add(Ask::kGo, i, name, "near " + name);
    }
    if (const char* on = switched(name)) {
      add(Ask::kTurnOn, i, name, "is " + name + " " + on, is(name, on));
      add(Ask::kTurnOff, i, name, "not " + name + " " + on, !is(name, on));
    }
    if (name == "fridge" || name == "microwave") {
      const bool open = std::any_of(start_.is.begin(), start_.is.end(), [&](const auto& fact) {
        return fact.first == name && fact.second.ends_with("DoorIsOpen");
      });
      add(Ask::kOpen, i, name, "open " + name, open);
      add(Ask::kClose, i, name, "close " + name, !open);
    }
    if (name == "burner" || name == "stove") of_burners(i, name);
  }

  void of_movable(int i, const std::string& name) {
    add(Ask::kTake, i, name, "take " + name, start_.held.contains(name));
    add(Ask::kRelease, i, name, "release " + name, !start_.held.contains(name));
    add(Ask::kMoveAway, i, name, "away " + name);
    if (here_.contains("garbage_bin"))
      add(Ask::kDiscard, i, name, "at " + name + " garbage_bin", start_.at.contains({name, "garbage_bin"}));
    for (int j = 0; j < static_cast<int>(message_.named.size()); ++j)
      for (const ClassId id : message_.named[static_cast<std::size_t>(j)].classes) {
        const ObjectClass& other = lexicon_.object_class(id);
        if (j == i || other.name == name || !is_place(other)) continue;
        const std::string place = other.name == "stove" ? "burner" : other.name;
        Request& put = add(Ask::kPut, i, name, "at " + name + " " + place, start_.at.contains({name, place}));
        put.other = j, put.other_class = place;
      }
  }

  void of_content(int i, const std::string& name) {
    for (int j = 0; j < static_cast<int>(message_.named.size()); ++j) {
      const Symbol content = message_.named[static_cast<std::size_t>(j)].content;
      if (j == i || content == symbol::kNone) continue;
      const std::string& value = symbols_.name(content);
      Request& fill = add(Ask::kFill, i, name, "is " + name + " " + value, is(name, value));
      fill.other = j, fill.other_class = value;
    }
  }

  void of_burners(int i, const std::string& name) {
    for (int number = 1; number <= kBurners; ++number) {
      const std::string fire = "StoveFire" + std::to_string(number);
      add(Ask::kLightBurner, i, name, "is stove " + fire, is("stove", fire)).number = number;
      add(Ask::kPutOutBurner, i, name, "not stove " + fire, !is("stove", fire)).number = number;
    }
  }

  void of_television() {
    for (std::size_t i = 0; i < message_.words.size(); ++i) {
      const int number = small_number(message_.words[i]);
      if (number == 0) continue;
      const std::string value = "Channel" + std::to_string(number);
      Request& channel = add(Ask::kChannel, -1, "tv", "is tv " + value, is("tv", value));
      channel.number = number, channel.at = i;
    }
    add(Ask::kMute, -1, "tv", "not tv Volume", !is("tv", "Volume"));
    add(Ask::kUnmute, -1, "tv", "is tv Volume", is("tv", "Volume"));
  }

  const Message& message_;
  const Start& start_;
  const Lexicon& lexicon_;
  const Symbols& symbols_;
  std::set<std::string> here_;
  std::vector<Request> requests_;
};

}  // namespace

std::string class_name(Symbol object, const Instruction& here, const Lexicon& lexicon,
                       const Symbols& symbols) {
  const std::string& name = symbols.name(object);
  if (name.starts_with("Fridge")) return "fridge";
  if (const int index = here.find(object); index >= 0)
    return lexicon.object_class(here.objects[static_cast<std::size_t>(index)].class_id).name;
  return name;
}

std::vector<Request> possible_requests(const Message& message, int view, const Instruction& here,
                                       const SymState& start, const Lexicon& lexicon,
                                       const Symbols& symbols) {
  const Start known = by_class(start, here, lexicon, symbols);
  std::vector<Request> requests = Finder(message, here, known, lexicon, symbols).find();
  for (Request& request : requests) request.view = view;
  return requests;
}

}  // namespace goalnet::inference::gist

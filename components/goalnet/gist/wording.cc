#include "components/goalnet/gist/wording.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference::gist {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kTellsWhich = {
    "left"sv,  "right"sv,  "other"sv, "both"sv, "all"sv,   "every"sv,   "each"sv,   "small"sv, "large"sv,
    "big"sv,   "tall"sv,   "red"sv,   "blue"sv, "green"sv, "brown"sv,   "white"sv,  "black"sv, "second"sv,
    "third"sv, "fourth"sv, "first"sv, "half"sv, "near"sv,  "nearest"sv, "closest"sv};
constexpr std::array kCounts = {"two"sv, "three"sv, "four"sv, "2"sv,     "3"sv,
                                "4"sv,   "both"sv,  "all"sv,  "every"sv, "each"sv};
constexpr std::size_t kMostBefore = 2;   // words that tell which one
constexpr std::size_t kMostBetween = 2;  // "on the" between a thing and where it is

// "the book [on the coffee table]": a place right behind the thing that is not where it goes tells which one.
std::string where_it_is(const Message& message, int index, int other) {
  static constexpr std::array kWhere = {"on"sv, "upon"sv, "in"sv, "from"sv, "off"sv, "inside"sv, "at"sv};
  const std::size_t next = static_cast<std::size_t>(index) + 1;
  if (next >= message.named.size() || static_cast<int>(next) == other) return {};
  const Named& thing = message.named[next - 1];
  const Named& place = message.named[next];
  if (place.begin > thing.end + kMostBetween || message.sorts[place.begin] != "place" ||
      place.begin <= thing.end || !one_of(message.words[thing.end], kWhere))
    return {};
  std::string text =
      message.words[thing.end] == "in" || message.words[thing.end] == "inside" ? " in the" : " on the";
  for (std::size_t i = place.begin; i < place.end; ++i) text += " " + message.words[i];
  return text;
}

// What the message calls it, with what tells which one.
std::string name_of(const Message& message, int index, int other, const Language& language) {
  const Named& named = message.named[static_cast<std::size_t>(index)];
  std::size_t begin = named.begin;
  const auto tells = [&](const std::string& word) {
    return one_of(word, kTellsWhich) || one_of(word, kCounts) ||
           language.wanted_by_state(word) != Frame::kNone || language.complaint(word) != Frame::kNone;
  };
  while (begin > 0 && named.begin - begin < kMostBefore && tells(message.spoken[begin - 1])) --begin;
  std::string text = one_of(message.spoken[begin], kCounts) ? "" : "the";
  for (std::size_t i = begin; i < named.end; ++i) {
    // the likeliest spelling of a slip, but plurals as they were said
    const bool plural =
        message.spoken[i] != message.words[i] && singular(message.spoken[i]) == message.words[i];
    text += (text.empty() ? "" : " ") + (plural ? message.spoken[i] : message.words[i]);
  }
  const std::size_t behind = named.end;
  if (behind < message.words.size() && message.sorts[behind] == "number" &&
      (message.words[named.end - 1] == "burner" || message.words[named.end - 1] == "shelf" ||
       message.words[named.end - 1] == "armchair"))
    text += " " + message.words[behind];
  return text + where_it_is(message, index, other);
}

bool inside(const std::string& place) {
  static constexpr std::array kInside = {"fridge"sv,   "microwave"sv, "garbage_bin"sv, "garbage_bag"sv,
                                         "sink"sv,     "bowl"sv,      "mug"sv,         "glass"sv,
                                         "long_cup"sv, "kettle"sv,    "xbox"sv};
  return one_of(place, kInside);
}

std::string one_in_words(const Message& message, const Request& request, const Language& language) {
  const std::string thing = request.thing < 0 ? "" : name_of(message, request.thing, request.other, language);
  const std::string other = request.other < 0 ? "" : name_of(message, request.other, request.thing, language);
  switch (request.ask) {
    case Ask::kOpen:
      return "open " + thing;
    case Ask::kTake:
    case Ask::kMoveAway:
      return "take " + thing;
    case Ask::kEmpty:
      return "empty " + thing;
    case Ask::kFillWithWater:
      return "fill " + thing + " with water";
    case Ask::kFill: {
      if (request.other_class == "Water") return "fill " + thing + " with water";
      const std::string verb = request.other_class == "IceCream" ? "scoop "
                               : request.other_class == "Chocolate" || request.other_class == "Vanilla"
                                   ? "squeeze "
                                   : "add ";
      return verb + other + (verb == "scoop " ? " into " : verb == "squeeze " ? " on " : " to ") + thing;
    }
    case Ask::kDiscard:
      return "put " + thing + " in the garbage bin";
    case Ask::kPut:
      return "put " + thing + (inside(request.other_class) ? " in " : " on ") + other;
    case Ask::kHeat:
      return "heat " + thing;
    case Ask::kTurnOn:
      return request.thing_class == "fridge" ? "turn on the water dispenser" : "turn on " + thing;
    case Ask::kTurnOff:
      return request.thing_class == "fridge" ? "turn off the water dispenser" : "turn off " + thing;
    case Ask::kLightBurner:
      return "turn on burner " + std::to_string(request.number);
    case Ask::kPutOutBurner:
      return "turn off burner " + std::to_string(request.number);
    case Ask::kChannel:
      return "change the channel to " + std::to_string(request.number);
    case Ask::kMute:
      return "mute the tv";
    case Ask::kUnmute:
      return "turn up the volume";
    case Ask::kGo:
      return "go to " + thing;
    case Ask::kClose:
      return "close " + thing;
    case Ask::kRelease:
      return "put down " + thing;
  }
  return {};
}

}  // namespace

std::string in_words(const Views& views, const std::vector<Request>& requests, const Language& language) {
  std::string text;
  for (const Request& request : requests)
    text += (text.empty() ? "" : " and ") +
            one_in_words(views[static_cast<std::size_t>(request.view)].message, request, language);
  return text;
}

}  // namespace goalnet::inference::gist

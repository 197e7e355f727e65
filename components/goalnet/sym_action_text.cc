// Actions to and from the spelling of the demonstrations.
#include <algorithm>
#include <array>
#include <sstream>

#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {
namespace {

constexpr std::array<const char*, kVerbs> kNames = {
    "noop", "moveto", "grasp", "release", "press", "turn",    "open",  "close", "keep",
    "keep", "keep",   "pour",  "pour",    "add",   "squeeze", "scoop", "place", "insert"};

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c | 0x20);
  return text;
}

}  // namespace

std::string to_string(const SymAction& action, const Symbols& symbols) {
  std::string text = kNames[static_cast<std::size_t>(action.verb)];
  if (action.x != symbol::kNone) text += " " + symbols.name(action.x);
  if (action.verb == Verb::kKeepOn) text += " On";
  if (action.verb == Verb::kKeepIn) text += " In";
  if (action.verb == Verb::kKeepNear) text += " Near";
  if (action.y != symbol::kNone) text += " " + symbols.name(action.y);
  return text;
}

Expected<SymAction> parse_action(std::string_view text, Symbols& symbols) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; stream >> word && words.size() < 5;) words.push_back(word);
  const auto name = [&](std::size_t i) {
    return i < words.size() ? symbols.intern(words[i]) : Symbol{symbol::kNone};
  };
  const auto bad = [&] {
    return fail(Outcome::kInvalidRequest, "unknown action \"" + std::string(text.substr(0, 60)) + "\"");
  };
  if (words.size() < 2) return bad();
  const std::string verb = lower(words[0]);
  SymAction action;
  action.x = name(1);
  if (verb == "keep" && words.size() == 4) {
    const std::string how = lower(words[2]);
    if (how != "on" && how != "in" && how != "near") return SymAction{Verb::kRelease, action.x};
    action.verb = how == "on" ? Verb::kKeepOn : how == "in" ? Verb::kKeepIn : Verb::kKeepNear;
    action.y = name(3);
    return action;
  }
  const auto known = std::find(kNames.begin(), kNames.end(), verb);
  if (known == kNames.end() || verb == "noop" || verb == "keep") return bad();
  action.verb = static_cast<Verb>(known - kNames.begin());
  if (action.verb == Verb::kPour && words.size() == 3) action.verb = Verb::kPourInto;
  const bool two = action.verb >= Verb::kPourInto;
  if (words.size() != (two ? 3u : 2u)) return bad();
  if (two) action.y = name(2);
  return action;
}

}  // namespace goalnet::inference

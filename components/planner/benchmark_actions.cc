#include "components/planner/benchmark_actions.h"

#include <array>
#include <vector>

#include "components/planner/symbols.h"

namespace goalnet::planner {
namespace {

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

// Demonstrations write knobs, buttons and doors in lower case, but "SinkKnob" and "Microwave" as they are.
std::string part_name(const std::string& name) {
  const std::string small = lower(name);
  const bool part = small.starts_with("stoveknob") || small.ends_with("button") ||
                    small.starts_with("fridge") || small == "icecreamscoop";
  return part ? small : name;
}

// The domain's spelling of names that demonstrations write in lower case.
std::string domain_name(const std::string& name) {
  static constexpr std::array<const char*, 20> kParts = {"FridgeLeftDoor",
                                                         "FridgeRightDoor",
                                                         "StoveKnob_1",
                                                         "StoveKnob_2",
                                                         "StoveKnob_3",
                                                         "StoveKnob_4",
                                                         "SinkKnob",
                                                         "MicrowaveButton",
                                                         "FridgeButton",
                                                         "Tv_1PowerButton",
                                                         "Tv_1ChannelUpButton",
                                                         "Tv_1ChannelDownButton",
                                                         "Tv_1VolumeUpButton",
                                                         "Tv_1VolumeDownButton",
                                                         "Tv_1Remote_1PowerButton",
                                                         "Tv_1Remote_1ChannelUpButton",
                                                         "Tv_1Remote_1ChannelDownButton",
                                                         "Tv_1Remote_1VolumeUpButton",
                                                         "Tv_1Remote_1VolumeDownButton",
                                                         "Tv_1Remote_1MuteButton"};
  for (const char* part : kParts) {
    if (equal_ignoring_case(part, name)) return part;
  }
  return equal_ignoring_case("IceCreamScoop", name) ? "IceCreamScoop" : name;
}

}  // namespace

Expected<Action> from_demonstration(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c != ' ' && c != '\t') {
      words.back().push_back(c);
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  const auto bad = [&] {
    return fail(Outcome::kInvalidRequest, "not an action of the demonstrations: '" +
                                              std::string(text.substr(0, 80)) +
                                              "'; write it like 'moveto Mug_1' or 'keep Mug_1 On Sink'");
  };
  if (words.empty()) return bad();
  const std::string verb = lower(words[0]);
  const std::size_t count = words.size();
  const auto argument = [&](std::size_t i) { return domain_name(words[i]); };
  if (verb == "noop" && count == 1) return Action{};
  if (verb == "keep" && count == 4) {
    const std::string relation = lower(words[2]);
    if (relation == "on" || relation == "in" || relation == "near") {
      return Action{"keep-" + relation, {argument(1), argument(3)}};
    }
    return Action{"release", {argument(1)}};
  }
  if (count == 2) {
    for (const char* name : {"moveto", "grasp", "release", "turn", "press", "open", "close"}) {
      if (verb == name) return Action{verb, {argument(1)}};
    }
    if (verb == "pour") return Action{"pour-out", {argument(1)}};
  }
  if (count == 3) {
    for (const char* name : {"pour", "add", "squeeze", "scoop", "place", "insert"}) {
      if (verb == name) return Action{verb, {argument(1), argument(2)}};
    }
  }
  return bad();
}

std::string to_demonstration(const Action& action) {
  if (action.name.empty()) return "noop";
  const auto& arguments = action.arguments;
  if (action.name.starts_with("keep-") && arguments.size() == 2) {
    const std::string relation = action.name == "keep-on" ? "On" : action.name == "keep-in" ? "In" : "Near";
    return "keep " + arguments[0] + " " + relation + " " + arguments[1];
  }
  std::string verb = action.name;
  for (const char* several : {"turn-", "press-"}) {
    if (verb.starts_with(several)) verb.resize(std::string_view(several).size() - 1);
  }
  if (verb == "pour-out") verb = "pour";
  if (verb == "place-utensil") verb = "place";
  std::string text = verb;
  const bool parts = verb == "turn" || verb == "press" || verb == "open" || verb == "close" || verb == "add";
  for (const std::string& argument : arguments) text += " " + (parts ? part_name(argument) : argument);
  return text;
}

}  // namespace goalnet::planner

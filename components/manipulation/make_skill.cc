#include <algorithm>

#include "components/manipulation/place_candidates.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

const char* const kScoop = "IceCreamScoop";
const char* const kSpoon = "Spoon_1";

bool known(const Workbench& bench, const std::string& name) {
  const auto& scene = bench.scene();
  return scene.find_object(name) || scene.find_fixture(name) || scene.find_part(name) ||
         scene.rules.find_spot(name) != nullptr || !regions_of(scene, name).empty();
}

Expected<void> need_part(const Workbench& bench, const std::string& name,
                         std::initializer_list<scene::PartUse> uses) {
  const auto ref = bench.scene().find_part(name);
  if (ref && std::find(uses.begin(), uses.end(), ref.part->use) != uses.end()) return {};
  return fail(Outcome::kInvalidRequest, "'" + name + "' is nothing that this action can be done with");
}

}  // namespace

const std::vector<std::pair<std::string, std::size_t>>& skill_names() {
  static const std::vector<std::pair<std::string, std::size_t>> kNames = {
      {"moveto", 1},        {"grasp", 1},    {"release", 1},   {"stow", 1},  {"unstow", 1},
      {"keep-on", 2},       {"keep-in", 2},  {"open", 1},      {"close", 1}, {"turn-on", 1},
      {"turn-off", 1},      {"press-on", 1}, {"press-off", 1}, {"press", 1}, {"pour", 2},
      {"pour-out", 1},      {"squeeze", 2},  {"add", 2},       {"scoop", 2}, {"insert", 2},
      {"place-utensil", 2}, {"fill", 2},
  };
  return kNames;
}

namespace {

Expected<std::unique_ptr<Skill>> make_plain_skill(const Workbench& bench, const Action& action) {
  const auto& names = skill_names();
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == action.name; });
  if (found == names.end()) {
    return fail(Outcome::kInvalidRequest,
                "manipulation does not know the action '" + to_string(action) + "'");
  }
  if (found->second != action.arguments.size()) {
    return fail(Outcome::kInvalidRequest, "'" + to_string(action) + "': " + action.name + " takes " +
                                              std::to_string(found->second) + " argument(s)");
  }
  for (const auto& argument : action.arguments) {
    // A scoop of ice cream is no thing of the scene: it lies in the spoon.
    if (argument == kScoop && action.name == "add") continue;
    if (!known(bench, argument)) {
      return fail(Outcome::kUnknownObject,
                  "'" + to_string(action) + "': this scene has no '" + argument + "'");
    }
  }
  const std::string& name = action.name;
  const std::string& x = action.arguments[0];
  using Where = PlaceSkill::Where;
  const auto need_object = [&]() -> Expected<void> {
    if (bench.scene().find_object(x)) return {};
    return fail(Outcome::kInvalidRequest, "'" + to_string(action) + "': '" + x + "' cannot be picked up");
  };
  // Something to pour or put into.
  const auto need_opening = [&](const std::string& receiver) -> Expected<void> {
    const auto* into = bench.scene().find_model_of(receiver);
    if (into != nullptr && into->cavity && receiver != x) return {};
    return fail(Outcome::kInvalidRequest,
                "'" + to_string(action) + "': nothing can be put in or on '" + receiver + "'");
  };
  using Result = Expected<std::unique_ptr<Skill>>;
  if (name == "moveto") return Result(std::make_unique<MoveSkill>(x));
  if (const auto& tears = bench.scene().rules.tears;
      name == "open" &&
      std::any_of(tears.begin(), tears.end(), [&](const auto& rule) { return rule.object == x; })) {
    return Result(std::make_unique<TearSkill>(x));
  }
  if (name == "turn-on" || name == "turn-off" || name == "open" || name == "close") {
    const bool knob = name.starts_with("turn");
    if (auto ok = need_part(bench, x, {knob ? scene::PartUse::kKnob : scene::PartUse::kDoor}); !ok) {
      return tl::unexpected<Error>(ok.error());
    }
    return Result(std::make_unique<TurnSkill>(x, name == "turn-on" || name == "open"));
  }
  if (name.starts_with("press")) {
    if (auto ok = need_part(bench, x, {scene::PartUse::kButton}); !ok && !bench.scene().rules.find_spot(x))
      return tl::unexpected<Error>(ok.error());
    return Result(std::make_unique<PressSkill>(x));
  }
  if (name == "add" && x == kScoop) {
    if (auto ok = need_opening(action.arguments[1]); !ok) return tl::unexpected<Error>(ok.error());
    return Result(
        std::make_unique<GestureSkill>(action, GestureSkill::Kind::kPour, kSpoon, action.arguments[1]));
  }
  if (auto ok = need_object(); !ok) return tl::unexpected<Error>(ok.error());
  const auto* model = bench.scene().find_model_of(x);
  // What cannot be poured goes in as a whole.
  const bool put = name == "insert" || name == "place-utensil" || (name == "add" && !model->cavity) ||
                   (name.starts_with("keep") && bench.scene().find_object(action.arguments[1]));
  if (put) {
    const std::string& receiver = action.arguments[1];
    if (auto ok = need_opening(receiver); !ok) return tl::unexpected<Error>(ok.error());
    return Result(std::make_unique<PutSkill>(action, x, receiver));
  }
  if (name == "pour" || name == "squeeze" || name == "add" || name == "pour-out" || name == "scoop") {
    const auto kind = name == "scoop" ? GestureSkill::Kind::kScoop : GestureSkill::Kind::kPour;
    const std::string receiver = action.arguments.size() > 1 ? action.arguments[1] : "";
    if (!receiver.empty()) {
      if (auto ok = need_opening(receiver); !ok) return tl::unexpected<Error>(ok.error());
    }
    if (kind == GestureSkill::Kind::kPour && !model->cavity) {
      return fail(Outcome::kInvalidRequest,
                  "'" + to_string(action) + "': '" + x + "' has no opening to pour from");
    }
    return Result(std::make_unique<GestureSkill>(action, kind, x, receiver));
  }
  if (name == "fill") {
    for (const auto& outlet : bench.scene().rules.fills) {
      if (outlet.fixture == action.arguments[1] && model->cavity && model->cavity->liquid)
        return Result(std::make_unique<FillSkill>(x, outlet));
    }
    return fail(Outcome::kInvalidRequest, "'" + to_string(action) + "': nothing runs there into '" + x + "'");
  }
  if (name == "grasp" || name == "unstow") return Result(std::make_unique<GraspSkill>(x));
  if (name == "release") return Result(std::make_unique<PlaceSkill>(x, Where::kNearest, ""));
  if (name == "stow") return Result(std::make_unique<PlaceSkill>(x, Where::kTray, ""));
  if (regions_of(bench.scene(), action.arguments[1]).empty()) {
    return fail(Outcome::kInvalidRequest,
                "'" + to_string(action) + "': nothing can be put in or on '" + action.arguments[1] + "'");
  }
  return Result(std::make_unique<PlaceSkill>(x, Where::kRegion, action.arguments[1]));
}

}  // namespace

Expected<std::unique_ptr<Skill>> make_skill(const Workbench& bench, const Action& action) {
  auto skill = make_plain_skill(bench, action);
  if (!skill || action.name == "moveto") return skill;
  std::set<std::string> arguments(action.arguments.begin(), action.arguments.end());
  if (arguments.contains(kScoop)) arguments.insert(kSpoon);
  const auto again = [action](const Workbench& b) {
    auto anew = make_plain_skill(b, action);
    return anew ? std::move(*anew) : nullptr;
  };
  return Expected<std::unique_ptr<Skill>>(
      std::make_unique<RoomSkill>(std::move(*skill), arguments, 0, again));
}

}  // namespace goalnet::manipulation

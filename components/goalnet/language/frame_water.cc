// Filling: with what, from where.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::fill_with_water(Symbol vessel) {
  if (now_.is(vessel, kWater)) return {};
  if (!resolver_.exists(kSink)) return not_here("there is no tap here to take water from");
  if (!now_.has(Relation::kOn, vessel, kSink))
    if (const Problem problem = act({Verb::kKeepOn, vessel, kSink}); !problem.empty()) return problem;
  if (now_.is(vessel, kWater)) return {};
  if (now_.is(kSinkKnob, kTapIsOn))  // it ran past the vessel: once more
    if (const Problem problem = act({Verb::kTurn, kSinkKnob}); !problem.empty()) return problem;
  const bool was_off = !start_.is(kSinkKnob, kTapIsOn) && !tap_asked_;
  const Problem problem = act({Verb::kTurn, kSinkKnob});
  tap_fills_ = problem.empty() && was_off;
  return problem;
}

std::string FrameActions::fill_one(Symbol vessel, Symbol content) {
  if (now_.is(vessel, content)) return {};
  const Symbol source = vessel_with(content);
  if (source != kNone && source != vessel && content != kWater) return act({Verb::kPourInto, source, vessel});
  if (content == kWater) return fill_with_water(vessel);
  if (content == kIceCream) return scoop_into(vessel, 1);
  return "nothing here holds that to pour it";
}

std::string FrameActions::fill(const Clause& said) {
  Clause clause = said;
  Symbol content = mentioned_content(clause, Role::kWith);
  fill_it_into_place(clause, content);
  want_what_is_named_in(clause, content);
  const bool hot = std::ranges::any_of(clause.phrases, [](const NounPhrase& phrase) {
    return phrase.role == Role::kWith && phrase.has("hot");
  });
  Objects sources;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kSource && !phrase.pronoun)
      sources = resolver_.options(phrase, Sort::kVessel, now_);
  std::erase_if(clause.phrases, [](const NounPhrase& p) { return p.role == Role::kSource; });
  Problem problem;
  const auto vessels = direct(clause, Sort::kVessel, problem);
  if (!problem.empty()) return problem;
  if (const NounPhrase* with = clause.first(Role::kWith);
      with != nullptr && (content == kNone || is_sprinkled(content)))
    return fill_with(*with, vessels, content);
  if (content == kNone && !sources.empty()) content = content_of(sources.front());
  if (content == kNone) content = kWater;
  for (const Symbol vessel : vessels) {
    const bool from = !sources.empty() && now_.is(sources.front(), content) && sources.front() != vessel;
    problem = from ? pour_into(sources.front(), vessel, true) : fill_one(vessel, content);
    if (!problem.empty()) return problem;
  }
  return hot && content == kWater ? heat_objects(vessels, true, nullptr) : Problem{};
}

// "fill water into the mug": the mug is what is filled
void FrameActions::fill_it_into_place(Clause& clause, Symbol& content) const {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || content != kNone || clause.first(Role::kDestination) == nullptr ||
      language_.content(thing->phrase) == kNone || !thing->content.empty())
    return;
  content = language_.content(thing->phrase);
  std::erase_if(clause.phrases, [](const NounPhrase& p) { return p.role == Role::kDirect; });
  for (NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDestination) phrase.role = Role::kDirect;
}

// "fill a glass of water", "fill the mug with coffee": the content is wanted, not there
void FrameActions::want_what_is_named_in(Clause& clause, Symbol& content) const {
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDirect || phrase.content.empty() || content != kNone) continue;
    content = language_.content(phrase.content);
    phrase.content.clear();
  }
}

// "the coffee needs a squirt of chocolate"
bool FrameActions::is_sprinkled(Symbol content) const {
  return at_home_ && (content == kSalt || content == kChocolate || content == kVanilla || content == kRamen ||
                      content == kEgg);
}

std::string FrameActions::fill_with(const NounPhrase& with, const Objects& vessels, Symbol content) {
  if (with.everything && !with.at.empty() && !with.at.front().pronoun && !with.at.front().bare()) {
    const auto from = resolver_.options(with.at.front(), Sort::kVessel, now_);  // "with what is in the mug"
    if (content == kNone && !from.empty()) content = content_of(from.front());
    if (content == kNone) return "there is nothing in that to fill it with";
  }
  if (with.has("everything") || with.pronoun) return "it is not clear what to fill it with";
  const bool poured = content != kNone && !is_sprinkled(content);
  bool done = content != kNone;
  for (const Symbol vessel : vessels)
    if (const Problem problem = poured ? fill_one(vessel, content) : add_content(with, vessel, done);
        !problem.empty())
      return problem;
  return done ? Problem{} : "it is not known how to fill something with " + with.word;
}

// The first of what it holds that can be poured; kNone where it holds none of that.
Symbol FrameActions::content_of(Symbol vessel) const {
  for (Symbol content = kWater; content <= kEgg; ++content)
    if (now_.is(vessel, content)) return content;
  return kNone;
}

}  // namespace goalnet::inference

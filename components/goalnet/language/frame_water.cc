// Filling and pouring.
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
  // "fill water into the mug"
  const NounPhrase* thing = clause.first(Role::kDirect);
  Symbol content = mentioned_content(clause, Role::kWith);
  if (thing != nullptr && content == kNone && clause.first(Role::kDestination) != nullptr &&
      language_.content(thing->phrase) != kNone && thing->content.empty()) {
    content = language_.content(thing->phrase);
    std::erase_if(clause.phrases, [](const NounPhrase& p) { return p.role == Role::kDirect; });
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination) phrase.role = Role::kDirect;
  }
  // "fill a glass of water", "fill the mug with coffee": the content is wanted, not there
  bool hot = false;
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role == Role::kDirect && !phrase.content.empty() && content == kNone) {
      content = language_.content(phrase.content);
      phrase.content.clear();
    }
    hot = hot || (phrase.role == Role::kWith && phrase.has("hot"));
  }
  Objects sources;
  Problem problem;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kSource && !phrase.pronoun)
      sources = resolver_.options(phrase, Sort::kVessel, now_);
  std::erase_if(clause.phrases, [](const NounPhrase& p) { return p.role == Role::kSource; });
  const auto vessels = direct(clause, Sort::kVessel, problem);
  if (!problem.empty()) return problem;
  const NounPhrase* with = clause.first(Role::kWith);
  if (with != nullptr &&
      (content == kNone || (at_home_ && (content == kSalt || content == kChocolate || content == kVanilla ||
                                         content == kRamen || content == kEgg)))) {
    if (with->everything && !with->at.empty() && !with->at.front().pronoun && !with->at.front().bare()) {
      const auto from =
          resolver_.options(with->at.front(), Sort::kVessel, now_);  // "with what is in the mug"
      for (Symbol c = kWater; c <= kEgg && !from.empty() && content == kNone; ++c)
        if (now_.is(from.front(), c)) content = c, sources = {from.front()};
      if (content == kNone) return "there is nothing in that to fill it with";
    }
    if (with->has("everything") || with->pronoun) return "it is not clear what to fill it with";
    // "the coffee needs a squirt of chocolate"
    const bool sprinkled = at_home_ && (content == kSalt || content == kChocolate || content == kVanilla ||
                                        content == kRamen || content == kEgg);
    bool done = content != kNone;
    for (const Symbol vessel : vessels)
      if (problem =
              content != kNone && !sprinkled ? fill_one(vessel, content) : add_content(*with, vessel, done);
          !problem.empty())
        return problem;
    return done ? Problem{} : "it is not known how to fill something with " + with->word;
  }
  if (content == kNone && !sources.empty())
    for (Symbol c = kWater; c <= kEgg && content == kNone; ++c)
      if (now_.is(sources.front(), c)) content = c;
  if (content == kNone) content = kWater;
  for (const Symbol vessel : vessels) {
    const bool from = !sources.empty() && now_.is(sources.front(), content) && sources.front() != vessel;
    problem = from ? pour_into(sources.front(), vessel, true) : fill_one(vessel, content);
    if (!problem.empty()) return problem;
  }
  return hot && content == kWater ? heat_objects(vessels, true, nullptr) : Problem{};
}

// Others may hold the same: a source that somebody named must be empty in the end, or the planner may take
// another.
std::string FrameActions::pour_into(Symbol source, Symbol vessel, bool named) {
  std::vector<SymFact> held;
  for (Symbol content = kWater; content <= kSalt; ++content)
    if (now_.is(source, content)) held.push_back(sym_fact(Relation::kState, source, content));
  const Problem problem = act({Verb::kPourInto, source, vessel});
  if (!problem.empty() || !named || !at_home_) return problem;
  auto& removed = steps_.back().removed;  // sorted
  removed.insert(removed.end(), held.begin(), held.end());
  std::sort(removed.begin(), removed.end());
  removed.erase(std::unique(removed.begin(), removed.end()), removed.end());
  return {};
}

std::string FrameActions::pour(const Clause& clause) {
  Problem problem;
  const NounPhrase* thing = clause.first(Role::kDirect);
  const NounPhrase* destination = clause.first(Role::kDestination);
  const NounPhrase* source_phrase = clause.first(Role::kSource);
  // "pour the coffee in the long cup into the glass": of two places the first is where it is
  if (std::count_if(clause.phrases.begin(), clause.phrases.end(),
                    [](const NounPhrase& phrase) {
                      return phrase.role == Role::kDestination && !phrase.joined;
                    }) == 2 &&
      source_phrase == nullptr && destination->where == Where::kIn) {
    Clause from = clause;
    // "pour the coffee into the bowl on the counter": the second is where the first is
    if (NounPhrase& last = from.phrases.back();
        at_home_ && last.role == Role::kDestination && !last.pronoun && !last.bare() && lexicon_place(last) &&
        resolver_.named(last).front() != kSink && &last != from.first(Role::kDestination)) {
      const NounPhrase there = last;
      from.phrases.pop_back();
      for (NounPhrase& phrase : from.phrases)
        if (phrase.role == Role::kDestination) phrase.at.push_back(there);
      return pour(from);
    }
    const auto first = std::find_if(from.phrases.begin(), from.phrases.end(), [](const NounPhrase& phrase) {
      return phrase.role == Role::kDestination;
    });
    first->role = Role::kSource;
    return pour(from);
  }
  if (thing != nullptr && !thing->pronoun && destination == nullptr && !thing->content.empty())
    return fill(clause);  // "pour me a cup of coffee"
  if (thing != nullptr && thing->everything && !thing->at.empty() && !thing->at.front().pronoun) {
    Clause from = clause;  // "pour whatever is in the mug into the sink"
    for (NounPhrase& phrase : from.phrases)
      if (phrase.role == Role::kDirect) {
        phrase = NounPhrase(thing->at.front());
        phrase.role = Role::kDirect;
      }
    return pour(from);
  }
  const Symbol content = mentioned_content(clause, Role::kDirect);
  if (content == kIceCream && destination != nullptr) return scoop(clause);
  if (thing != nullptr && !thing->pronoun && destination != nullptr) {
    const auto shaken = resolver_.options(*thing, Sort::kMovable, now_);
    if (!shaken.empty() && (shaken.front() == kSalt_1 || now_.has(Relation::kIsSqueezeable, shaken.front()) ||
                            shaken.front() == kRamen_1 || shaken.front() == kBoiledEgg_1))
      return add_to(clause);
    // "pour the chips into the bowl": what is no liquid is put there
    if (!shaken.empty() && content == kNone && resolver_.class_of(shaken.front())->food &&
        !resolver_.is_vessel(shaken.front()))
      return put(clause);
  }
  Objects targets;
  if (destination != nullptr) {
    if (destination->pronoun) {
      targets = pronoun(*destination, Sort::kVessel, {});
    } else if (!destination->bare()) {
      NounPhrase into = *destination;
      targets = resolver_.options(into, Sort::kVessel, now_);
      if (destination->all || destination->count > 1)
        targets = resolver_.chosen(into, targets);
      else if (destination->ordinal > 0)
        targets = resolver_.chosen(into, targets);
    }
    if (targets.empty() && (destination->pronoun || destination->bare() ||
                            resolver_.options(*destination, Sort::kPlace, now_).empty()))
      return unknown_thing(*destination, Sort::kVessel);
    if (targets.empty() && !resolver_.options(*destination, Sort::kPlace, now_).empty() &&
        resolver_.options(*destination, Sort::kPlace, now_).front() != kSink)
      return "nothing can be poured there";
    if (!destination->all && destination->count < 2 && targets.size() > 1)
      targets.erase(targets.begin() + 1, targets.end());
  }
  // "it was meant to be in the glass, pour it over"
  if (at_home_ && destination == nullptr && clause.has_particle("over") && !last_destination_.empty() &&
      resolver_.is_vessel(last_destination_.front())) {
    targets = {last_destination_.front()};
    if (thing == nullptr || thing->pronoun) {
      bool full = false;
      for (Symbol c = kWater; c <= kEgg; ++c)
        full = full || (now_.is(targets.front(), c) && !start_.is(targets.front(), c));
      if (full) return {};  // it is done already
    }
  }
  Symbol source = kNone;
  if (source_phrase != nullptr && !source_phrase->pronoun) {
    const auto options = resolver_.options(*source_phrase, Sort::kVessel, now_);
    if (options.empty() && content == kWater && !targets.empty())
      source = kNone;  // from the tap
    else if (options.empty())
      return unknown_thing(*source_phrase, Sort::kVessel);
    else
      source = options.front();
    for (const Symbol option : options)  // "the coke from the can": the one that holds some
      if (at_home_ && content != kNone && !now_.is(source, content) && now_.is(option, content))
        source = option;
  } else if (content != kNone) {
    source = vessel_with(content);
    // "one water in the glass, two in the long cups": each from the tap
    if (at_home_ && content == kWater && source != kNone && !thing->definite && source_phrase == nullptr &&
        (thing->count > 0 || targets.size() > 1))
      source = kNone;
    if (source == kNone && content != kWater) {
      const auto cans = resolver_.options(*thing, Sort::kVessel, now_);
      return cans.empty() ? "nothing here holds " + thing->word
                          : resolver_.name(cans.front()) + " holds nothing that could be poured";
    }
  } else {
    const auto objects = direct(clause, Sort::kVessel, problem);
    if (!problem.empty()) return problem;
    source = objects.front();
  }
  if (source == kNone && content == kWater && !targets.empty()) {
    for (const Symbol target : targets)
      if (problem = fill_with_water(target); !problem.empty()) return problem;
    remember(targets);
    return {};
  }
  if (source == kNone && content == kWater && at_home_) return make(clause);  // "pour me some water"
  if (source == kNone) return "nothing here holds that to pour it";
  bool holds_something = false;
  for (Symbol c = kWater; c <= kEgg; ++c) holds_something = holds_something || now_.is(source, c);
  if (targets.empty()) {
    remember({source});
    return holds_something ? act({Verb::kPour, source}) : Problem{};
  }
  if (!holds_something) return resolver_.name(source) + " is empty";
  std::erase(targets, source);
  if (at_home_ && targets.empty() && content != kNone) {  // "coffee in the mug", where it is
    remember({source});
    return thing->has("hot") || thing->has("warm") ? heat_objects({source}, true, nullptr) : Problem{};
  }
  if (targets.empty()) return "a thing cannot be poured into itself";
  if (targets.size() > 1)
    return "what " + resolver_.name(source) + " holds can be poured into one vessel only";
  const bool only_content = source_phrase == nullptr && content != kNone && thing != nullptr &&
                            thing->content.empty() && thing->at.empty();  // "pour the coffee into the glass"
  problem = pour_into(source, targets.front(), !only_content);
  if (at_home_) last_destination_ = {targets.front()};
  remember(targets);
  return problem;
}

}  // namespace goalnet::inference

// Pouring: what, from where, into what.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::pour(const Clause& clause) {
  static constexpr Reading kReadings[] = {
      &FrameActions::pour_from_first_place,  // "pour the coffee in the long cup into the glass"
      &FrameActions::pour_a_cup,             // "pour me a cup of coffee"
      &FrameActions::pour_whatever_is_in,    // "pour whatever is in the mug into the sink"
      &FrameActions::pour_what_is_no_drink,  // "pour the chips into the bowl"
  };
  if (const auto read = first_that_fits(kReadings, clause)) return *read;
  Problem problem;
  Objects targets = pour_targets(clause, problem);
  if (!problem.empty()) return problem;
  if (pour_over(clause, targets)) return {};  // it is done already
  const Symbol content = mentioned_content(clause, Role::kDirect);
  const Symbol source = pour_source(clause, content, targets, problem);
  if (!problem.empty()) return problem;
  if (source == kNone && content == kWater && !targets.empty()) {
    for (const Symbol target : targets)
      if (problem = fill_with_water(target); !problem.empty()) return problem;
    remember(targets);
    return {};
  }
  if (source == kNone && content == kWater && at_home_) return make(clause);  // "pour me some water"
  if (source == kNone) return "nothing here holds that to pour it";
  return pour_out(clause, content, source, targets);
}

// "pour the coffee in the long cup into the glass": of two places the first is where it is
std::optional<std::string> FrameActions::pour_from_first_place(const Clause& clause) {
  const auto place = [](const NounPhrase& phrase) { return phrase.role == Role::kDestination; };
  const auto places = std::ranges::count_if(
      clause.phrases, [&](const NounPhrase& phrase) { return place(phrase) && !phrase.joined; });
  if (places != 2 || clause.first(Role::kSource) != nullptr ||
      clause.first(Role::kDestination)->where != Where::kIn)
    return std::nullopt;
  Clause from = clause;
  // "pour the coffee into the bowl on the counter": the second is where the first is
  if (NounPhrase& last = from.phrases.back(); at_home_ && place(last) && !last.pronoun && !last.bare() &&
                                              lexicon_place(last) && resolver_.named(last).front() != kSink &&
                                              &last != from.first(Role::kDestination)) {
    const NounPhrase there = last;
    from.phrases.pop_back();
    for (NounPhrase& phrase : from.phrases)
      if (place(phrase)) phrase.at.push_back(there);
    return pour(from);
  }
  std::ranges::find_if(from.phrases, place)->role = Role::kSource;
  return pour(from);
}

// "pour me a cup of coffee"
std::optional<std::string> FrameActions::pour_a_cup(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || thing->pronoun || clause.first(Role::kDestination) != nullptr ||
      thing->content.empty())
    return std::nullopt;
  return fill(clause);
}

// "pour whatever is in the mug into the sink"
std::optional<std::string> FrameActions::pour_whatever_is_in(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || !thing->everything || thing->at.empty() || thing->at.front().pronoun)
    return std::nullopt;
  Clause from = clause;
  for (NounPhrase& phrase : from.phrases)
    if (phrase.role == Role::kDirect) {
      phrase = NounPhrase(thing->at.front());
      phrase.role = Role::kDirect;
    }
  return pour(from);
}

// Ice cream is scooped, salt is shaken, chips are put there.
std::optional<std::string> FrameActions::pour_what_is_no_drink(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  const Symbol content = mentioned_content(clause, Role::kDirect);
  if (clause.first(Role::kDestination) == nullptr) return std::nullopt;
  if (content == kIceCream) return scoop(clause);
  if (thing == nullptr || thing->pronoun) return std::nullopt;
  const auto shaken = resolver_.options(*thing, Sort::kMovable, now_);
  if (shaken.empty()) return std::nullopt;
  const Symbol first = shaken.front();
  if (first == kSalt_1 || now_.has(Relation::kIsSqueezeable, first) || first == kRamen_1 ||
      first == kBoiledEgg_1)
    return add_to(clause);
  // "pour the chips into the bowl": what is no liquid is put there
  if (content == kNone && resolver_.class_of(first)->food && !resolver_.is_vessel(first)) return put(clause);
  return std::nullopt;
}

// The vessels that it is poured into; none for the sink, or where no place is said.
FrameActions::Objects FrameActions::pour_targets(const Clause& clause, Problem& problem) {
  const NounPhrase* destination = clause.first(Role::kDestination);
  if (destination == nullptr) return {};
  Objects targets = meant_by(*destination, Sort::kVessel);
  if (!destination->pronoun && !destination->bare() &&
      (destination->all || destination->count > 1 || destination->ordinal > 0))
    targets = resolver_.chosen(*destination, targets);
  if (targets.empty() && (destination->pronoun || destination->bare() ||
                          resolver_.options(*destination, Sort::kPlace, now_).empty()))
    problem = unknown_thing(*destination, Sort::kVessel);
  else if (targets.empty() && !resolver_.options(*destination, Sort::kPlace, now_).empty() &&
           resolver_.options(*destination, Sort::kPlace, now_).front() != kSink)
    problem = "nothing can be poured there";
  if (!destination->all && destination->count < 2 && targets.size() > 1)
    targets.erase(targets.begin() + 1, targets.end());
  return targets;
}

// "it was meant to be in the glass, pour it over": the glass. Whether that was filled already.
bool FrameActions::pour_over(const Clause& clause, Objects& targets) const {
  if (!at_home_ || clause.first(Role::kDestination) != nullptr || !clause.has_particle("over") ||
      last_destination_.empty() || !resolver_.is_vessel(last_destination_.front()))
    return false;
  targets = {last_destination_.front()};
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing != nullptr && !thing->pronoun) return false;
  bool full = false;
  for (Symbol c = kWater; c <= kEgg; ++c)
    full = full || (now_.is(targets.front(), c) && !start_.is(targets.front(), c));
  return full;
}

// What it is poured from; kNone: from the tap, or from nothing.
Symbol FrameActions::pour_source(const Clause& clause, Symbol content, const Objects& targets,
                                 Problem& problem) {
  const NounPhrase *thing = clause.first(Role::kDirect), *from = clause.first(Role::kSource);
  if (from != nullptr && !from->pronoun) return named_source(*from, content, targets, problem);
  if (content == kNone) {
    const auto objects = direct(clause, Sort::kVessel, problem);
    return problem.empty() ? objects.front() : Symbol{kNone};
  }
  const Symbol source = vessel_with(content);
  // "one water in the glass, two in the long cups": each from the tap
  if (at_home_ && content == kWater && source != kNone && !thing->definite && from == nullptr &&
      (thing->count > 0 || targets.size() > 1))
    return kNone;
  if (source == kNone && content != kWater) {
    const auto cans = resolver_.options(*thing, Sort::kVessel, now_);
    problem = cans.empty() ? "nothing here holds " + thing->word
                           : resolver_.name(cans.front()) + " holds nothing that could be poured";
  }
  return source;
}

// "the coke from the can": the one that holds some
Symbol FrameActions::named_source(const NounPhrase& from, Symbol content, const Objects& targets,
                                  Problem& problem) {
  const auto options = resolver_.options(from, Sort::kVessel, now_);
  if (options.empty()) {
    const bool tap = content == kWater && !targets.empty();
    if (!tap) problem = unknown_thing(from, Sort::kVessel);
    return kNone;
  }
  Symbol source = options.front();
  for (const Symbol option : options)
    if (at_home_ && content != kNone && !now_.is(source, content) && now_.is(option, content))
      source = option;
  return source;
}

std::string FrameActions::pour_out(const Clause& clause, Symbol content, Symbol source, Objects targets) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  const bool holds_something = content_of(source) != kNone;
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
  const bool only_content = clause.first(Role::kSource) == nullptr && content != kNone && thing != nullptr &&
                            thing->content.empty() && thing->at.empty();  // "pour the coffee into the glass"
  const Problem problem = pour_into(source, targets.front(), !only_content);
  if (at_home_) last_destination_ = {targets.front()};
  remember(targets);
  return problem;
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

}  // namespace goalnet::inference

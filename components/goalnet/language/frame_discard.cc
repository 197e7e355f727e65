// Throwing away: in the bin, out of a vessel, to somebody.
#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::discard(const Clause& clause) {
  static constexpr Reading kReadings[] = {
      &FrameActions::discard_content,       // "discard everything that is in the mug"
      &FrameActions::throw_to_place,        // "throw the chips in the bin"
      &FrameActions::throw_in_named_bin,    // "throw coke bin"
      &FrameActions::throw_to_person,       // "throw me the remote"
      &FrameActions::throw_in,              // "throw in an egg"
      &FrameActions::throw_nowhere,         // "throw the can"
      &FrameActions::discard_what_is_told,  // "there is coffee in the mug, get rid of it"
  };
  if (const auto read = first_that_fits(kReadings, clause)) return *read;
  const Symbol content = mentioned_content(clause, Role::kDirect);
  const Symbol bin = resolver_.exists(kGarbageBin_1) ? Symbol{kGarbageBin_1} : Symbol{kNone};
  if (bin == kNone && content != kNone && clause.first(Role::kDirect) != nullptr) return pour(clause);
  if (bin == kNone) return not_here("there is no bin here to throw things into");
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    if (object == bin) return "the bin cannot be thrown into itself";
    if (problem = keep(object, bin, Where::kIn); !problem.empty()) return problem;
  }
  return {};
}

std::optional<std::string> FrameActions::discard_content(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || thing == nullptr || !thing->everything) return std::nullopt;
  const NounPhrase* in = clause.first(Role::kDestination);
  if (in == nullptr) in = clause.first(Role::kSource);
  if (in == nullptr && thing->at.size() == 1) in = &thing->at.front();
  if (in == nullptr || in->pronoun || in->bare() || in->unknown) return std::nullopt;
  const Objects vessels = resolver_.options(*in, Sort::kVessel, now_);
  if (vessels.empty() || vessels.front() == kGarbageBin_1 || resolver_.taken(vessels.front(), now_))
    return std::nullopt;
  Clause emptied = clause;
  emptied.frame = Frame::kEmpty, emptied.verb = "empty";
  emptied.phrases = {*in};
  emptied.phrases.front().role = Role::kDirect;
  return empty(emptied);
}

// "throw the chips in the bin", "throw away the chips on the couch"
std::optional<std::string> FrameActions::throw_to_place(const Clause& clause) {
  const NounPhrase* to = clause.first(Role::kDestination);
  if (to == nullptr) return std::nullopt;
  const auto at = to->pronoun || to->bare() ? Objects{} : resolver_.options(*to, Sort::kPlace, now_);
  const bool bin = !at.empty() && (at.front() == kGarbageBin_1 || at.front() == kGarbageBag_1);
  const bool away = clause.has_particle("away") || clause.has_particle("out") || clause.verb == "discard" ||
                    clause.verb == "trash";
  if (bin || !away) return put(clause);
  Clause located = clause;
  for (NounPhrase& phrase : located.phrases)
    if (phrase.role == Role::kDestination) phrase.role = Role::kSource;
  return discard(located);
}

// "throw coke bin"
std::optional<std::string> FrameActions::throw_in_named_bin(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || thing == nullptr || thing->pronoun || thing->bare() ||
      (thing->content.empty() && thing->modifier.empty()) || !resolver_.exists(kGarbageBin_1) ||
      !contains(resolver_.named(*thing), Symbol{kGarbageBin_1}))
    return std::nullopt;
  Clause away = clause;
  NounPhrase& thrown = away.phrases.front();
  thrown.phrase = thrown.word = thing->modifier.empty() ? thing->content : thing->modifier;
  thrown.modifier.clear(), thrown.content.clear();
  away.verb = "discard";
  return discard(away);
}

std::optional<std::string> FrameActions::throw_to_person(const Clause& clause) {
  if (!clause.to_person) return std::nullopt;
  return take(clause);
}

// "throw in an egg"
std::optional<std::string> FrameActions::throw_in(const Clause& clause) {
  if (!clause.has_particle("in") || clause.first(Role::kDirect) == nullptr) return std::nullopt;
  const bool bin_told = !last_destination_.empty() && (last_destination_.front() == kGarbageBin_1 ||
                                                       last_destination_.front() == kGarbageBag_1);
  if (at_home_ && bin_told) {  // "if the beer is not in the bin, throw it in"
    Clause binned = clause;
    binned.particles.clear(), binned.verb = "discard";
    return discard(binned);
  }
  Clause added = clause;
  added.frame = Frame::kAdd, added.verb = "add";
  return add_to(added);
}

// "throw the can" says too little; "toss it" is for the bin.
std::optional<std::string> FrameActions::throw_nowhere(const Clause& clause) {
  const bool flung =
      clause.verb == "throw" || (!at_home_ && (clause.verb == "toss" || clause.verb == "chuck"));
  if (!flung || clause.has_particle("away") || clause.has_particle("out")) return std::nullopt;
  return "it is not clear where to " + clause.verb + " that; say \"throw ... away\" for the bin";
}

// "there is coffee in the mug, get rid of it": the coffee
std::optional<std::string> FrameActions::discard_what_is_told(const Clause& clause) {
  const NounPhrase* said = clause.first(Role::kDirect);
  if (said == nullptr || !said->pronoun || content_told_.empty()) return std::nullopt;
  Clause away = clause;
  away.phrases = {*said};
  away.phrases.front().pronoun = false;
  away.phrases.front().phrase = away.phrases.front().word = content_told_;
  return pour(away);
}

}  // namespace goalnet::inference

#include "components/goalnet/language/frame_actions.h"

#include <algorithm>

#include "components/goalnet/language/home_rules.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

constexpr int kMostExamples = 5;

bool contains(const std::vector<Symbol>& list, Symbol symbol) {
  return std::find(list.begin(), list.end(), symbol) != list.end();
}

}  // namespace

std::string FrameActions::unknown_thing(const NounPhrase& phrase, Sort sort) const {
  if (phrase.pronoun)
    return "it is not clear what \"" + (phrase.word.empty() ? "it" : phrase.word) + "\" means here";
  if (phrase.unknown) return unknown_name(phrase.word);
  if (phrase.bare()) return "it is not clear what is meant";
  const std::string said = phrase.word.empty() ? phrase.phrase : phrase.word;
  if (!resolver_.named(phrase).empty()) {
    const std::string name = resolver_.name(resolver_.named(phrase).front());
    switch (sort) {
      case Sort::kMovable:
        return now_.has(Relation::kIsGraspable, resolver_.named(phrase).front())
                   ? "no " + said + " here is as the sentence says; there is " + name
                   : name + " cannot be picked up";
      case Sort::kPlace:
        return "nothing can be put on or into " + name;
      case Sort::kDevice:
        return name + " cannot be turned on or off";
      case Sort::kVessel:
        return name + " is nothing that one could fill or pour from";
      case Sort::kAny:
        break;
    }
    return "no " + said + " here is as the sentence says; there is " + name;
  }
  std::string examples;
  int count = 0;
  for (const Symbol object : resolver_.all(sort, now_))
    if (count++ < 3) examples += (examples.empty() ? "" : ", ") + resolver_.name(object);
  return not_here("there is no " + said + " here" +
                  (examples.empty() ? "" : "; there are, for example, " + examples));
}

std::string FrameActions::not_here(Problem problem) const {
  missing_ = problem;
  return problem;
}

// A name that no thing of any world has. Of an English word it is known what kind of thing that would be:
// milk is a drink, so the drinks that are here are told; of others the nearest in spelling.
std::string FrameActions::unknown_name(const std::string& word) const {
  const std::string kind = language_.kind_of(word);
  if (kind.empty()) return not_here(language_.unknown_word(word));
  std::string examples;
  int count = 0;
  for (const SeenObject& object : resolver_.objects()) {
    const ObjectClass* c = resolver_.class_of(object.symbol);
    if (c == nullptr || !c->is(kind) || count++ >= kMostExamples) continue;
    examples += (examples.empty() ? "" : ", ") + resolver_.name(object.symbol);
  }
  return not_here("there is no " + word + " here" +
                  (examples.empty() ? ", nor any other " + kind
                                    : "; of the same kind (" + kind + ") there are " + examples));
}

void FrameActions::remember(const Objects& objects) {
  if (objects.empty()) return;
  history_.push_back(objects);
  resolver_.remember(objects);
}

// What "it" and "them" mean: the newest things spoken of that are of the sort.
FrameActions::Objects FrameActions::pronoun(const NounPhrase& phrase, Sort sort,
                                            const Objects& not_these) const {
  const auto fitting = [&](const Objects& from) {
    Objects result;
    const Objects all = resolver_.all(sort, now_);
    for (const Symbol object : from) {
      const bool burner = sort == Sort::kDevice && object >= kStoveFire_1 && object <= kStoveFire_4;
      if ((burner || contains(all, object)) && !contains(not_these, object)) result.push_back(object);
    }
    return result;
  };
  if (phrase.word == "there" && !last_destination_.empty()) return last_destination_;
  Objects found;
  for (auto it = history_.rbegin(); it != history_.rend(); ++it) {
    const Objects fit = fitting(*it);
    for (const Symbol object : fit)
      if (!contains(found, object)) found.push_back(object);
    if (!found.empty() && (!phrase.plural || found.size() > 1)) break;
  }
  if (found.empty()) {
    Objects held;
    for (const SymFact fact : now_.facts())
      if (relation_of(fact) == Relation::kGrasping) held.push_back(object_of(fact));
    found = fitting(held);
  }
  if (!phrase.plural && found.size() > 1) found.erase(found.begin() + 1, found.end());
  if (phrase.count > 0 && found.size() > static_cast<std::size_t>(phrase.count))
    found.resize(static_cast<std::size_t>(phrase.count));
  return found;
}

FrameActions::Objects FrameActions::objects_of(const NounPhrase& phrase, Sort sort, const Clause& clause) {
  if (phrase.pronoun) return pronoun(phrase, sort, {});
  if (phrase.bare() || phrase.unknown) return {};
  NounPhrase located = phrase;
  for (const NounPhrase& source : clause.phrases)
    if (source.role == Role::kSource && !source.pronoun && phrase.role == Role::kDirect)
      located.at.push_back(source);
  Objects options = resolver_.options(located, sort, now_);
  for (const NounPhrase& left_out : clause.phrases) {
    if (left_out.role != Role::kExcept) continue;
    NounPhrase these = left_out;
    if (these.phrase.empty()) these.phrase = phrase.phrase;
    const Objects excluded = resolver_.options(these, sort, now_);
    std::erase_if(options, [&](Symbol object) { return contains(excluded, object); });
  }
  // "put a book on the shelf" means one that is not there yet
  if (!avoid_.empty() && !phrase.plural && !phrase.all && phrase.role == Role::kDirect)
    std::stable_partition(options.begin(), options.end(),
                          [&](Symbol object) { return !contains(avoid_, resolver_.place_of(object, now_)); });
  return resolver_.chosen(phrase, options);
}

FrameActions::Objects FrameActions::role_objects(const Clause& clause, Role role, Sort sort,
                                                 Problem& problem) {
  Objects objects;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != role || (phrase.alternative && !objects.empty())) continue;
    const Objects chosen = objects_of(phrase, sort, clause);
    if (chosen.empty() && !phrase.alternative && problem.empty()) problem = unknown_thing(phrase, sort);
    if (!chosen.empty() && phrase.alternative) problem.clear();
    for (const Symbol object : chosen)
      if (!contains(objects, object)) objects.push_back(object);
  }
  return objects;
}

FrameActions::Objects FrameActions::direct(const Clause& clause, Sort sort, Problem& problem) {
  Objects objects = role_objects(clause, Role::kDirect, sort, problem);
  if (objects.empty() && problem.empty()) problem = "it is not clear what to " + clause.verb;
  if (problem.empty()) remember(objects);
  return objects;
}

// Where things go: as many places as there are things when people say "each", otherwise one; a free one where
// several are equal.
FrameActions::Objects FrameActions::places(const NounPhrase& phrase, const Objects& for_these,
                                           std::size_t wanted, Problem& problem) {
  if (phrase.pronoun) {
    Objects there = pronoun(phrase, Sort::kPlace, for_these);
    if (there.empty() && problem.empty()) problem = "it is not clear where \"" + phrase.word + "\" is";
    return there;
  }
  Objects options =
      phrase.bare() || phrase.unknown ? Objects{} : resolver_.options(phrase, Sort::kPlace, now_);
  std::erase_if(options, [&](Symbol option) { return contains(for_these, option); });
  // "the other couch": not the one that they stand on
  if (options.size() > 1 && phrase.number == 0 && phrase.ordinal == 0 && !phrase.all &&
      (phrase.has("other") || phrase.has("different") || moves_)) {
    Objects elsewhere = options;
    std::erase_if(elsewhere, [&](Symbol place) {
      return std::any_of(for_these.begin(), for_these.end(),
                         [&](Symbol o) { return resolver_.place_of(o, now_) == place; });
    });
    if (!elsewhere.empty()) options = elsewhere;
  }
  if (phrase.ordinal > 0 || phrase.has("last")) options = resolver_.chosen(phrase, options);
  if (options.empty()) {
    if (problem.empty()) problem = unknown_thing(phrase, Sort::kPlace);
    return {};
  }
  // Burners and seats: the free ones first. Of those that stay equal, the one that the things stand on
  // already.
  const ObjectClass* c = resolver_.class_of(options.front());
  if (c != nullptr && (c->name == "burner" || c->name == "armchair"))
    std::stable_partition(options.begin(), options.end(), [&](Symbol place) {
      const Objects there = resolver_.things_at(place, now_);
      return std::all_of(there.begin(), there.end(),
                         [&](Symbol thing) { return contains(for_these, thing); });
    });
  if (wanted > 1 && (phrase.all || phrase.count > 1 || phrase.plural)) return options;
  options.erase(options.begin() + 1, options.end());
  return options;
}

Symbol FrameActions::mentioned_content(const Clause& clause, Role role) const {
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == role)
      if (const Symbol content = language_.content(phrase.phrase); content != kNone) return content;
  return kNone;
}

Symbol FrameActions::vessel_with(Symbol content) const {
  Symbol best = kNone;
  for (const Symbol vessel : resolver_.all(Sort::kVessel, now_)) {
    if (!now_.is(vessel, content)) continue;
    if (best == kNone || now_.holds(vessel) ||
        (!now_.holds(best) && resolver_.distance(vessel) < resolver_.distance(best)))
      best = vessel;
  }
  return best;
}

Symbol FrameActions::burner_for(Symbol object) const {
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (now_.has(Relation::kOn, object, burner)) return burner;
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (resolver_.exists(burner) && !resolver_.taken(burner, now_)) return burner;
  return resolver_.exists(kStoveFire_1) ? Symbol{kStoveFire_1} : Symbol{kNone};
}

Symbol FrameActions::surface() const {
  for (const SeenObject& object : resolver_.objects())
    if (resolver_.is_of_class(object.symbol, "counter")) return object.symbol;
  for (const SeenObject& object : resolver_.objects())
    if (resolver_.is_of_class(object.symbol, "coffee_table")) return object.symbol;
  return kNone;
}

std::string FrameActions::act(const SymAction& macro) {
  const auto run = with_means(macro, now_);
  if (run.empty()) return "that cannot be done from here";
  SymDelta step;
  std::vector<Symbol> handled = {macro.x, macro.y};
  for (const SymAction& other : macros_) handled.push_back(other.x);
  std::erase_if(handled, [&](Symbol object) { return !resolver_.is_vessel(object); });
  for (const SymAction& action : run) {
    if (action == macro) step = purpose(action, now_, handled);
    apply_at_home(action, now_);
  }
  macros_.push_back(macro);
  steps_.push_back(std::move(step));
  return {};
}

std::string FrameActions::keep(Symbol x, Symbol y, Where where) {
  if (x == y) return "a thing cannot be put on itself";
  const bool box = y == kMicrowave || y == kFridge || y == kGarbageBin_1 || y == kGarbageBag_1 ||
                   y == kFridgeLeft || y == kFridgeRight;
  if (resolver_.is_of_class(x, "cd") && resolver_.is_of_class(y, "xbox")) {
    if (now_.has(Relation::kIn, x, y)) return {};
    return act({Verb::kInsert, x, y});
  }
  if (y == kMicrowave && where == Where::kOn) return "nothing can be put on top of the microwave";
  if (y == kFridge && where == Where::kOn) return "nothing can be put on top of the fridge";
  const ObjectClass* c = resolver_.class_of(y);
  const bool container = c != nullptr && (c->vessel || c->dish);
  if (container && (where == Where::kIn || !c->dish || c->name == "bowl")) {
    if (x == kRamen_1 || x == kBoiledEgg_1 || x == kSalt_1) {
      if (x != kSalt_1 && now_.has(Relation::kIn, x, y)) return {};
      return act({Verb::kAdd, x, y});
    }
    if (x == kSpoon_1 || x == kFork_1)
      return now_.has(Relation::kIn, x, y) ? Problem{} : act({Verb::kPlace, x, y});
  }
  const Verb verb =
      box || (where == Where::kIn && container && c->name != "plate") ? Verb::kKeepIn : Verb::kKeepOn;
  if (now_.has(verb == Verb::kKeepIn ? Relation::kIn : Relation::kOn, x, y)) return {};
  return act({verb, x, y});
}

void FrameActions::notice(const Clause& clause) {
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role == Role::kDestination && !phrase.pronoun && !phrase.bare() && !phrase.unknown)
      if (const Objects there = resolver_.options(phrase, Sort::kPlace, now_); !there.empty())
        last_destination_ = {there.front()};
    if (phrase.role != Role::kDirect || phrase.pronoun || phrase.bare() || phrase.unknown) continue;
    // what stands where the sentence says counts, not everything of that name
    Objects objects = resolver_.options(phrase, Sort::kAny, now_);
    if (!phrase.everything && !phrase.plural && !phrase.all && objects.size() > 1)
      objects.erase(objects.begin() + 1, objects.end());
    if (!objects.empty()) history_.push_back(objects);
  }
}

std::string FrameActions::check_forbidden(const Clause& clause, const SymState& start) const {
  if (clause.frame == Frame::kTry) {  // "without touching the coke"
    for (const NounPhrase& phrase : clause.phrases) {
      FrameActions untouched = *this;
      const Objects objects = phrase.pronoun || phrase.bare()
                                  ? Objects{}
                                  : untouched.resolver_.options(phrase, Sort::kAny, start);
      for (const SymAction& macro : macros_)
        if (contains(objects, macro.x))
          return "this cannot be done without touching " + resolver_.name(macro.x);
    }
    return {};
  }
  FrameActions other = *this;
  other.macros_.clear();
  other.steps_.clear();
  other.now_ = start;
  const std::string problem = other.add(clause);
  SymState now = start;
  for (const SymAction& macro : macros_) {
    for (const SymAction& action : with_means(macro, now)) {
      for (const SymAction& forbidden : other.macros_)
        if (action == forbidden && problem.empty())
          return "this cannot be done without what the sentence forbids";
      apply(action, now);
    }
  }
  // "without spilling anything", "don't break it": what nobody would do anyway
  return {};
}

std::string FrameActions::add(const Clause& clause) {
  if (!clause.unknown.empty()) return language_.unknown_word(clause.unknown.front());
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.unknown) return unknown_name(phrase.word);
  for (const Clause& condition : clause.condition) {
    Problem problem;
    const bool so = holds(condition, problem);
    if (!problem.empty()) return problem;
    notice(condition);
    if (!so) return {};
  }
  const SymState before = now_;
  const std::size_t count = macros_.size();
  const Problem problem = dispatch(clause);
  if (!problem.empty()) {
    now_ = before;
    macros_.resize(count);
    steps_.resize(count);
  }
  return problem;
}

// Whether "the tap is on", "the mug is in the sink" is so now.
bool FrameActions::holds(const Clause& statement, Problem& problem) {
  const NounPhrase& subject = statement.phrases.front();
  NounPhrase plain = subject;
  plain.at.clear();
  const Objects objects =
      subject.pronoun ? pronoun(subject, Sort::kAny, {}) : resolver_.options(plain, Sort::kAny, now_);
  if (objects.empty()) {
    problem = unknown_thing(subject, Sort::kAny);
    return false;
  }
  const Symbol object = objects.front();
  bool so = true;
  if (!subject.at.empty()) {
    const int loose = resolver_.doubts().loose;
    resolver_.options(subject, Sort::kAny, now_);
    so = resolver_.doubts().loose == loose;
    resolver_.doubts().loose = loose;
  }
  const std::string& state = statement.state;
  if (state == "on" || state == "running" || state == "lit" || state == "burning") {
    so = is_on(object);
  } else if (state == "off") {
    so = !is_on(object);
  } else if (state == "open" || state == "closed" || state == "shut") {
    const bool open = object == kFridge
                          ? now_.is(kFridge, kLeftDoorIsOpen) || now_.is(kFridge, kRightDoorIsOpen)
                      : object == kMicrowave ? now_.is(kMicrowave, kDoorIsOpen)
                                             : now_.is(object, kIsOpen);
    so = open == (state == "open");
  } else if (!state.empty()) {
    NounPhrase as_said = plain;
    as_said.adjectives.push_back(state == "filled" ? "full" : state);
    if (state != "empty" && state != "full" && state != "filled" && state != "hot" && state != "warm" &&
        state != "cold") {
      problem = "it is not known whether " + resolver_.name(object) + " is " + state;
      return false;
    }
    const int loose = resolver_.doubts().loose;
    resolver_.options(as_said, Sort::kAny, now_);
    so = resolver_.doubts().loose == loose;
    resolver_.doubts().loose = loose;
  }
  return so != statement.negative;
}

std::string FrameActions::dispatch(const Clause& clause) {
  switch (clause.frame) {
    case Frame::kGo:
      return go(clause);
    case Frame::kTake:
      return take(clause);
    case Frame::kPlace:
    case Frame::kBring:
      return put(clause);
    case Frame::kDiscard:
      return discard(clause);
    case Frame::kFill:
      return fill(clause);
    case Frame::kPour:
      return pour(clause);
    case Frame::kEmpty:
      return empty(clause);
    case Frame::kTurn:
      return turn(clause, -1);
    case Frame::kStart:
      return turn(clause, 1);
    case Frame::kStop:
      return turn(clause, 0);
    case Frame::kOpen:
      return door(clause, true);
    case Frame::kClose:
      return door(clause, false);
    case Frame::kWash:
      return wash(clause);
    case Frame::kHeat:
      return heat(clause, false);
    case Frame::kBoil:
      return heat(clause, true);
    case Frame::kAdd:
    case Frame::kSqueeze:
      return add_to(clause);
    case Frame::kScoop:
      return scoop(clause);
    case Frame::kInsert:
      return insert(clause);
    case Frame::kRelease:
      return release(clause);
    case Frame::kChange:
    case Frame::kMute:
    case Frame::kRaise:
    case Frame::kLower:
      return clause.frame == Frame::kRaise && !about_television(clause) ? take(clause) : television(clause);
    case Frame::kMake:
      return make(clause);
    case Frame::kSwap:
      return swap(clause);
    case Frame::kClear:
      return clear(clause);
    case Frame::kCool:
      return cool(clause);
    case Frame::kPlay:
      return play(clause);
    case Frame::kTry:
    case Frame::kNone:
      break;
  }
  return "there is no verb that a robot could act on";
}

}  // namespace goalnet::inference

// Whether what a sentence says is so, and whether what it forbids would be done.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

constexpr int kChannels = kChannel6 - kChannel1 + 1;

bool tells_content_or_heat(const std::string& state) {
  return state == "empty" || state == "full" || state == "filled" || state == "hot" || state == "warm" ||
         state == "cold";
}

}  // namespace

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
  // "don't wash the bowl, wash the plates": that needs the tap as well, but not the bowl
  Objects about;
  for (const NounPhrase& phrase : clause.phrases)
    if (at_home_ && phrase.role == Role::kDirect && !phrase.pronoun && !phrase.bare())
      for (const Symbol object : other.resolver_.options(phrase, Sort::kAny, start)) about.push_back(object);
  const auto concerns = [&](const SymAction& action) {
    return contains(about, action.x) || contains(about, action.y);
  };
  if (std::any_of(other.macros_.begin(), other.macros_.end(), concerns))
    std::erase_if(other.macros_, [&](const SymAction& action) { return !concerns(action); });
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

std::optional<bool> FrameActions::is_so(Symbol object, const std::string& state) const {
  const bool runs = at_home_ && language_.complaint(state) == Frame::kStop;
  if (state == "on" || state == "running" || state == "lit" || state == "burning" || runs)
    return is_on(object);
  if (state == "off") return !is_on(object);
  if (state == "open" || state == "closed" || state == "shut") {
    const bool open = object == kFridge
                          ? now_.is(kFridge, kLeftDoorIsOpen) || now_.is(kFridge, kRightDoorIsOpen)
                      : object == kMicrowave ? now_.is(kMicrowave, kDoorIsOpen)
                                             : now_.is(object, kIsOpen);
    return open == (state == "open");
  }
  if (const ObjectClass* c = resolver_.class_of(object);
      at_home_ && c != nullptr && c->place && (state == "free" || state == "empty" || state == "full"))
    return resolver_.taken(object, now_) == (state == "full");
  if (at_home_ && state == "muted" && resolver_.is_of_class(object, "tv")) return !now_.is(object, kVolume);
  if (at_home_ && resolver_.is_vessel(object) && (state == "full" || state == "filled" || state == "empty")) {
    bool full = false;
    for (Symbol content = kWater; content <= kEgg; ++content) full = full || now_.is(object, content);
    return full == (state != "empty");
  }
  return std::nullopt;
}

std::string FrameActions::contradicted(const Clause& statement) {
  if (statement.state.empty() || statement.negative || statement.phrases.empty()) return {};
  const NounPhrase& subject = statement.phrases.front();
  if (subject.pronoun || subject.bare() || subject.unknown || subject.person) return {};
  const Objects objects = resolver_.options(subject, Sort::kAny, now_);
  if (objects.empty() || std::any_of(objects.begin(), objects.end(), [&](Symbol object) {
        return is_so(object, statement.state).value_or(true);
      }))
    return {};
  return "nothing is done, since " + resolver_.name(objects.front()) + " is not " + statement.state;
}

bool FrameActions::wanted(const Clause& clause, Problem& problem) {
  for (Clause condition : clause.condition) {
    // "if the tap is on, turn it off and bring me the mug": as it was before anything was done
    const auto known = std::find_if(judged_.begin(), judged_.end(), [&](const auto& judged) {
      return at_home_ && judged.first == clause.condition_number;
    });
    bool so = known != judged_.end() && known->second;
    if (known == judged_.end()) {
      // "switch on the tv, unless it is on": the tv
      if (const NounPhrase* named = clause.first(Role::kDirect);
          condition.phrases.front().pronoun && history_.empty() && named != nullptr && !named->pronoun)
        condition.phrases.front() = *named;
      // "if the other couch is free, put the bowl there": not the one that it stands on
      if (const NounPhrase* moved = clause.first(Role::kDirect);
          at_home_ && condition.phrases.front().has("other") && moved != nullptr && !moved->pronoun &&
          !moved->bare())
        if (const Objects options = resolver_.options(*moved, Sort::kMovable, now_); !options.empty())
          if (const Symbol place = resolver_.place_of(options.front(), now_); place != kNone)
            resolver_.remember({place});
      so = holds(condition, problem);
      if (!problem.empty()) return false;
      if (NounPhrase& none = condition.phrases.front();
          condition.negative && !none.definite && !none.pronoun && none.at.size() == 1) {
        none = NounPhrase(none.at.front());  // "if no pillow is on the armchair": only that is spoken of
        none.role = Role::kDestination;
      }
      if (condition.negative)
        condition.phrases.front().content.clear();  // "the kettle has no water, fill it"
      notice(condition);
      judged_.emplace_back(clause.condition_number, so);
    }
    if (so == clause.otherwise) return false;
  }
  return true;
}

// Whether "the tap is on", "the mug is in the sink" is so now.
bool FrameActions::holds(const Clause& statement, Problem& problem) {
  const NounPhrase& subject = statement.phrases.front();
  if (at_home_ && language_.tv_word(subject.phrase) && subject.number > 0)  // "the tv is on channel three"
    return shows_channel(subject.number) != statement.negative;
  if (at_home_ && subject.everything && !subject.at.empty())  // "anything is on the stove"
    return anything_is_where_said(subject) != statement.negative;
  NounPhrase plain = subject;
  plain.at.clear();
  if (at_home_) plain.content.clear();
  const Objects objects =
      subject.pronoun ? pronoun(subject, Sort::kAny, {}) : resolver_.options(plain, Sort::kAny, now_);
  if (objects.empty()) {
    problem = unknown_thing(subject, Sort::kAny);
    return false;
  }
  Symbol object = object_judged(statement, plain, objects);
  bool so = true;
  if (const Symbol content = language_.content(subject.content);
      at_home_ && content != kNone) {  // "has coffee in it"
    const auto with = std::ranges::find_if(objects, [&](Symbol other) { return now_.is(other, content); });
    so = with != objects.end();
    if (so) object = *with;
  }
  if (!subject.at.empty()) so = is_as_said(subject);
  // "if there is coffee in the mug"
  if (const Symbol content = language_.content(subject.phrase);
      content != kNone && !subject.at.empty() && !subject.pronoun) {
    const NounPhrase& in = subject.at.front();
    const auto vessels = in.pronoun || in.bare() ? Objects{} : resolver_.options(in, Sort::kVessel, now_);
    if (!vessels.empty()) so = now_.is(vessels.front(), content);
  }
  const std::string& state = statement.state;
  if (const auto is_now = is_so(object, state)) {
    so = *is_now;
  } else if (!state.empty()) {
    if (!tells_content_or_heat(state)) {
      problem = "it is not known whether " + resolver_.name(object) + " is " + state;
      return false;
    }
    plain.adjectives.push_back(state == "filled" ? "full" : state);
    so = is_as_said(plain);
  }
  return so != statement.negative;
}

bool FrameActions::shows_channel(int number) const {
  return is_on(kTv_1) && number <= kChannels && now_.is(kTv_1, static_cast<Symbol>(kChannel1 + number - 1));
}

// "it" is what is there from here on.
bool FrameActions::anything_is_where_said(const NounPhrase& subject) {
  Objects there = resolver_.options(subject, Sort::kMovable, now_);
  std::erase_if(there, [&](Symbol object) { return !resolver_.is_where_said(object, subject, now_); });
  if (!there.empty()) remember(there);
  return !there.empty();
}

// Of several the one that is counted ("the second couch is free"), the one that is so ("one of the burners is
// on"), else the first.
Symbol FrameActions::object_judged(const Clause& statement, const NounPhrase& plain, const Objects& objects) {
  if (!at_home_) return objects.front();
  if (plain.ordinal > 0 && !plain.pronoun) {
    const Objects meant = resolver_.chosen(plain, objects);
    return meant.empty() ? objects.front() : meant.front();
  }
  if (plain.ordinal == 0)
    for (const Symbol other : objects)
      if (is_so(other, statement.state).value_or(false)) return other;
  return objects.front();
}

// Whether some object is all that the phrase says.
bool FrameActions::is_as_said(const NounPhrase& phrase) {
  const int loose = resolver_.doubts().loose;
  resolver_.options(phrase, Sort::kAny, now_);
  const bool so = resolver_.doubts().loose == loose;
  resolver_.doubts().loose = loose;
  return so;
}

}  // namespace goalnet::inference

#include "components/goalnet/language/clause.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"

namespace goalnet::inference {
namespace {

using std::string_view_literals::operator""sv;

template <std::size_t N>
bool one_of(const std::string& word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::array kParticles = {"on"sv,      "off"sv,   "up"sv,    "down"sv,    "out"sv,
                                   "away"sv,    "over"sv,  "in"sv,    "back"sv,    "around"sv,
                                   "through"sv, "aside"sv, "along"sv, "together"sv};
constexpr std::array kDeterminers = {"the"sv, "a"sv, "an"sv, "my"sv, "some"sv, "your"sv};
constexpr std::array kSubordinate = {"if"sv,     "unless"sv,    "when"sv,    "once"sv,     "after"sv,
                                     "before"sv, "while"sv,     "until"sv,   "because"sv,  "since"sv,
                                     "so"sv,     "where"sv,     "without"sv, "whenever"sv, "as"sv,
                                     "till"sv,   "otherwise"sv, "though"sv,  "although"sv};
// Frames whose places say where the thing is, not where it should go: "take the cup on the counter".
bool locates(Frame frame) {
  return frame == Frame::kTake || frame == Frame::kWash || frame == Frame::kOpen || frame == Frame::kClose ||
         frame == Frame::kFill || frame == Frame::kTurn || frame == Frame::kStart || frame == Frame::kStop ||
         frame == Frame::kCool;
}
// Frames that put one thing to another with "with".
bool adds(Frame frame) {
  return frame == Frame::kFill || frame == Frame::kAdd || frame == Frame::kSqueeze || frame == Frame::kMake ||
         frame == Frame::kScoop || frame == Frame::kSwap || frame == Frame::kPour;
}
// Frames whose object may be followed by the state it should be in: "leave the door open".
bool takes_state(Frame frame) {
  return frame == Frame::kTake || frame == Frame::kPlace || frame == Frame::kMake || frame == Frame::kBring;
}

}  // namespace

bool Clause::has(const std::string& word) const {
  return std::find(words.begin(), words.end(), word) != words.end() || has_particle(word) ||
         std::any_of(phrases.begin(), phrases.end(),
                     [&](const NounPhrase& p) { return p.phrase == word || p.has(word); });
}

bool Clause::has_particle(const std::string& word) const {
  return std::find(particles.begin(), particles.end(), word) != particles.end();
}

const NounPhrase* Clause::first(Role role) const {
  for (const NounPhrase& phrase : phrases)
    if (phrase.role == role) return &phrase;
  return nullptr;
}

std::size_t ClauseParser::skip_joins(std::size_t at, std::size_t end) const {
  while (at < end &&
         (language_.joins(words_[at]) ||
          (language_.filler(words_[at]) && !reader_.starts(at, end) && !language_.asks(words_[at]) &&
           words_[at] != "let" && words_[at] != "i" && words_[at] != "we" && !place_preposition(words_[at]) &&
           !one_of(words_[at], kSubordinate) && !one_of(words_[at], kParticles) &&
           language_.verb(words_[at]) == Frame::kNone)))
    ++at;
  return at;
}

bool ClauseParser::harmless(std::size_t at) const {
  return language_.filler(words_[at]) || language_.adverb(words_[at]);
}

// Whether the word is a verb here. "microwave" and "spoon" are things too: they are verbs before a thing.
bool ClauseParser::opens_command(std::size_t at, std::size_t end) const {
  if (at >= end || language_.verb(words_[at]) == Frame::kNone) return false;
  const std::size_t name = reader_.name_length(at);
  if (name == 0) return true;
  if (name > 1) return false;
  std::size_t next = at + 1;
  while (next < end && (words_[next] == "up" || words_[next] == "out" || words_[next] == "on")) ++next;
  if (next < end && (is_pronoun(words_[next]) || words_[next] == "that" || words_[next] == "this"))
    return true;
  return reader_.starts(next, end) && !(next == at + 1 && reader_.name_length(next) > 0 && at > 0 &&
                                        (words_[at - 1] == "the" || words_[at - 1] == "a"));
}

bool ClauseParser::starts_clause(std::size_t at, std::size_t end) const {
  if (at >= end) return false;
  if (words_[at] == "not" || words_[at] == "never" || words_[at] == "wish" ||
      one_of(words_[at], kSubordinate))
    return true;
  return opens_command(at, end);
}

std::size_t ClauseParser::skip_part(std::size_t at, std::size_t end) const {
  while (at < end && words_[at] != ",") ++at;
  return at;
}

void ClauseParser::add(Clause clause) {
  if (clause.mood == Mood::kCommand && clause.condition.empty()) clause.condition = condition_;
  if (insert_before_ < result_.clauses.size()) {
    // "before putting the mug away, wash it": "it" was named by the clause that is done later
    name_pronouns(clause, result_.clauses[insert_before_]);
    result_.clauses.insert(result_.clauses.begin() + static_cast<long>(insert_before_), std::move(clause));
    insert_before_ = SIZE_MAX;
  } else {
    result_.clauses.push_back(std::move(clause));
  }
}

void ClauseParser::name_pronouns(Clause& clause, const Clause& by) const {
  const NounPhrase* named = by.first(Role::kDirect);
  if (named == nullptr || named->pronoun) return;
  for (NounPhrase& phrase : clause.phrases) {
    if (!phrase.pronoun || phrase.word == "there") continue;
    const Role role = phrase.role;
    const Where where = phrase.where;
    phrase = *named;
    phrase.role = role, phrase.where = where;
  }
}

ParsedSentence ClauseParser::parse() {
  for (std::size_t begin = 0; begin < words_.size();) {
    std::size_t end = begin;
    while (end < words_.size() && words_[end] != ".") ++end;
    for (std::size_t at = begin; at < end;) {
      const std::size_t next = clause(at, end);
      at = std::max(next, at + 1);
    }
    fronted_.clear();
    condition_.clear();
    begin = end + 1;
  }
  return std::move(result_);
}

std::size_t ClauseParser::clause(std::size_t at, std::size_t end) {
  at = skip_joins(at, end);
  if (at >= end) return at;
  const std::string& word = words_[at];
  if (word == "not" || word == "never" || word == "without") {
    std::size_t verb = at + 1;
    while (verb < end && !opens_command(verb, end) && harmless(verb)) ++verb;
    if (opens_command(verb, end)) return command(verb, end, Mood::kForbidden);
    const std::size_t gerund = at + 1;
    if (gerund < end && words_[gerund].size() > 5 && words_[gerund].ends_with("ing") &&
        !language_.known(words_[gerund])) {
      Clause clause;  // "without touching the coke", "without spilling anything"
      clause.mood = Mood::kForbidden, clause.frame = Frame::kTry, clause.verb = words_[gerund];
      NounPhrase phrase;
      const std::size_t done = reader_.read(gerund + 1, end, phrase);
      if (done != gerund + 1) clause.phrases.push_back(phrase);
      add(std::move(clause));
      return std::max(done, gerund + 1);
    }
    if (word == "without") {  // "without the spoon"
      NounPhrase phrase;
      const std::size_t done = reader_.read(verb, end, phrase);
      if (done != verb) return done;
    }
    if (result_.problem.empty()) result_.problem = "it is not clear what \"" + word + "\" rules out";
    return at + 1;
  }
  if (word == "ensure") {
    std::size_t next = at + 1;
    while (next < end && (words_[next] == "that" || words_[next] == "you" || words_[next] == "to")) ++next;
    if (opens_command(next, end)) return command(next, end, Mood::kCommand);
    ensured_ = true;
    const std::size_t done = next < end ? statement(next, end) : next;
    ensured_ = false;
    return done;
  }
  if (word == "let") {  // "let the water run"
    NounPhrase phrase;
    const std::size_t done = reader_.read(at + 1, end, phrase);
    if (done != at + 1 && !phrase.person && opens_command(done, end)) {
      fronted_ = {phrase};
      return command(done, end, Mood::kCommand);
    }
    return at + 1;
  }
  if (word == "use" || word == "using" || word == "with") {  // "use the spoon to scoop ice cream"
    NounPhrase phrase;
    std::size_t next = reader_.read(at + 1, end, phrase);
    const bool read = next != at + 1;
    while (read && next < end && (words_[next] == "to" || language_.joins(words_[next]))) ++next;
    if (read && opens_command(next, end)) {
      phrase.role = Role::kWith;
      fronted_ = {phrase};
      return command(next, end, Mood::kCommand);
    }
  }
  if (word == "wish" || (word == "have" && reader_.starts(at + 1, end)))
    return command(at, end, Mood::kCommand);
  if (language_.asks(word) && at + 1 < end && language_.copula(words_[at + 1])) return question(at, end);
  if (one_of(word, kSubordinate) && !(word == "so" && opens_command(skip_joins(at + 1, end), end)))
    return subordinate(at, end);
  if (word == "so") return at + 1;
  if (opens_command(at, end)) return command(at, end, Mood::kCommand);
  if (language_.asks(word)) return question(at, end);
  // "in the sink, put the mug"
  NounPhrase place;
  if (const std::size_t done = reader_.read_place(at, end, place); done != at) {
    const std::size_t next = skip_joins(done, end);
    if (opens_command(next, end)) {
      place.role = Role::kDestination;
      fronted_ = {place};
      return next;
    }
  }
  return statement(at, end);
}

std::size_t ClauseParser::subordinate(std::size_t at, std::size_t end) {
  const std::string& word = words_[at];
  const std::size_t count = result_.clauses.size();
  if ((word == "if" || word == "unless") && at + 1 < end) {  // "if the tap is on, turn it off"
    ClauseParser inner(*all_words_, language_, *lexicon_);
    std::size_t stop = at + 1;
    while (stop < end && words_[stop] != "," && words_[stop] != "then" &&
           !(stop > at + 2 && opens_command(stop, end) &&
             language_.wanted_by_state(words_[stop]) == Frame::kNone))
      ++stop;
    const std::size_t done = inner.statement(at + 1, stop);
    if (done >= stop && inner.result_.stray.empty() && inner.result_.clauses.size() == 1) {
      Clause clause = inner.result_.clauses.front();
      const bool says =
          !clause.state.empty() || (!clause.phrases.empty() && !clause.phrases.front().at.empty());
      if (clause.mood == Mood::kStatement && clause.frame == Frame::kNone && says) {
        clause.negative = clause.negative != (word == "unless");
        if (count > 0 && stop >= end)
          result_.clauses.back().condition = {clause};
        else
          condition_ = {clause};
        return stop;
      }
    }
  }
  if (word == "if" || word == "unless" || word == "whenever") {
    if (result_.problem.empty())
      result_.problem = "conditions (\"" + word + " ...\") are not understood; say what to do now";
    return skip_part(at, end);
  }
  if (word == "before" || word == "after" || word == "once" || word == "when") {
    std::size_t verb = at + 1;
    while (verb < end && !opens_command(verb, end) &&
           (harmless(verb) || words_[verb] == "you" || words_[verb] == "have"))
      ++verb;
    if (verb < end && opens_command(verb, end)) {
      const bool leading =
          count == 0 || at == 0 || words_[at - 1] == "." || words_[at - 1] == "," || words_[at - 1] == "then";
      if (word == "before" && leading) {
        const std::size_t done = command(verb, end, Mood::kCommand);
        if (result_.clauses.size() > count) insert_before_ = count;
        return done;
      }
      if (word != "before" && !leading) insert_before_ = count - 1;  // "A after B": B first
      return command(verb, end, Mood::kCommand);
    }
    if (verb >= end || words_[verb] == ",") return verb;  // "and after that, ..."
    // "once the mug is full, ...", "when it is done": what was asked before is done by then
    return skip_part(at, end);
  }
  if (word == "as" && at + 1 < end && (words_[at + 1] == "well" || words_[at + 1] == "soon")) return at + 2;
  // until it is hot; because I am thirsty; so that I can sit down; where it belongs; while you are there
  std::size_t next = at + 1;
  const bool reason = word == "since" || word == "because" || word == "while";
  const auto command_begins = [&](std::size_t i) {
    return reason && i > at + 2 && opens_command(i, end) && reader_.starts(i + 1, end) &&
           words_[i - 1] != "to" && words_[i - 1] != "i" && words_[i - 1] != "you" &&
           words_[i - 1] != "can" && words_[i - 1] != "not";
  };
  while (next < end && words_[next] != "," && !command_begins(next) &&
         !(words_[next] == "and" && opens_command(skip_joins(next, end), end)))
    ++next;
  return next;
}

std::size_t ClauseParser::command(std::size_t at, std::size_t end, Mood mood) {
  Clause clause;
  clause.mood = mood;
  clause.wish = words_[at] == "wish" || words_[at] == "have";
  clause.verb = clause.wish ? "bring" : language_.verb_base(words_[at]);
  clause.frame = clause.wish ? Frame::kTake : language_.verb(words_[at]);
  clause.words = {clause.verb};
  clause.phrases = fronted_;
  fronted_.clear();
  Role role = Role::kDirect;
  Where where = Where::kTo;
  std::size_t i = at + 1;
  // "start boiling water", "go get the mug", "try to open it": the second verb is the one that counts
  if (clause.frame == Frame::kGo || clause.frame == Frame::kStart || clause.frame == Frame::kTry ||
      clause.frame == Frame::kStop) {
    std::size_t k = i;
    while (k < end && (words_[k] == "and" || words_[k] == "to" || words_[k] == "me" || words_[k] == "over" ||
                       words_[k] == "ahead" || words_[k] == "there" || words_[k] == "by"))
      ++k;
    const bool and_only_go =
        k == i || words_[i] != "and" || clause.frame == Frame::kGo || clause.frame == Frame::kTry;
    if (k < end && and_only_go && opens_command(k, end) && clause.frame != Frame::kStop &&
        !(reader_.name_length(k) > 0 && words_[k - 1] == "to"))
      return command(k, end, mood);
  }
  while (i < end) {
    const std::string& word = words_[i];
    if (language_.joins(word)) {
      const std::size_t next = skip_joins(i, end);
      if (next < end && words_[next] == "not" && !opens_command(next + 1, end) &&
          reader_.starts(next + 1, end)) {
        i = next;
        continue;
      }
      if (next >= end || starts_clause(next, end)) break;
      NounPhrase phrase;
      const std::size_t done = reader_.read(next, end, phrase);
      if (done != next && !clause.phrases.empty()) {
        const std::size_t after = skip_joins(done, end);
        const bool statement_follows = done < end && (language_.copula(words_[done]) || phrase.person);
        if (statement_follows && after == done) break;
        for (std::size_t k = i; k < next; ++k) phrase.alternative = phrase.alternative || words_[k] == "or";
        for (std::size_t k = i; k < next; ++k)
          if (words_[k] == "except" || words_[k] == "but") phrase.role = Role::kExcept;
        // "put the mug in the sink and the glass on the counter": the verb counts again
        NounPhrase place;
        if (role == Role::kDestination && phrase.role != Role::kExcept && done < end &&
            reader_.read_place(done, end, place) != done) {
          Clause again;
          again.mood = clause.mood, again.verb = clause.verb, again.frame = clause.frame,
          again.words = {clause.verb};
          add(std::move(clause));
          clause = std::move(again);
          role = Role::kDirect, where = Where::kTo;
        }
        phrase.joined = role == Role::kDestination;
        // a list goes on; after "with X and Y" or "on X and Y" only where nothing moves to a place of its own
        if (phrase.role != Role::kExcept) phrase.role = role;
        phrase.where = where;
        clause.phrases.push_back(std::move(phrase));
        i = done;
        continue;
      }
      if (!clause.phrases.empty() && !reader_.starts(next, end) && !place_preposition(words_[next]) &&
          !one_of(words_[next], kParticles) && !harmless(next) && !language_.known(words_[next])) {
        if (one_of(words_[next - 1], kDeterminers)) {  // "the mug and the torch": a thing
          NounPhrase thing;
          thing.role = role, thing.where = where, thing.word = words_[next], thing.unknown = true;
          clause.phrases.push_back(std::move(thing));
        } else {
          clause.unknown.push_back(words_[next]);
        }
      }
      i = std::max(next, i + 1);
      continue;
    }
    if (word == "not" && i + 1 < end &&
        !opens_command(i + 1, end)) {  // "the mug, not the glass, in the sink"
      NounPhrase phrase;
      if (const std::size_t done = reader_.read(i + 1, end, phrase); done != i + 1) {
        phrase.role = Role::kExcept;
        clause.phrases.push_back(std::move(phrase));
        i = done;
        continue;
      }
    }
    if (word == "where" &&
        (clause.frame == Frame::kPlace || clause.frame == Frame::kBring)) {  // "where the mug is"
      NounPhrase beside;
      const std::size_t done = reader_.read(i + 1, end, beside);
      if (done != i + 1 && done < end && language_.copula(words_[done])) {
        beside.role = Role::kDestination, beside.where = Where::kNear;
        clause.phrases.push_back(std::move(beside));
        i = done + 1;
        continue;
      }
    }
    if (one_of(word, kSubordinate) || word == "not" || word == "never" || word == "wish") break;
    if (word == "except" || (word == "other" && i + 1 < end && words_[i + 1] == "than")) {
      NounPhrase phrase;
      std::size_t k = i + 1;
      while (k < end && (words_[k] == "for" || words_[k] == "than")) ++k;
      const std::size_t done = reader_.read(k, end, phrase);
      phrase.role = Role::kExcept;
      NounPhrase place, next_place;
      const std::size_t after = reader_.read_place(done, end, place);
      // "except the one on the shelf"; of "all but book 3 on the table" the table is where things go
      const bool its_place =
          after != done && (phrase.word == "one" || clause.first(Role::kDestination) != nullptr ||
                            reader_.read_place(after, end, next_place) != after);
      if (its_place) phrase.at.push_back(place);
      i = its_place ? after : std::max(done, i + 1);
      clause.phrases.push_back(std::move(phrase));
      continue;
    }
    // "take the mug to fill it", "use the spoon to scoop ice cream"
    if (word == "to" && i + 1 < end && opens_command(i + 1, end) && !reader_.name_length(i + 1)) {
      ++i;
      break;
    }
    clause.words.push_back(word);
    const std::size_t next = argument(i, end, clause, role, where);
    if (next == i) {
      clause.words.pop_back();
      break;
    }
    i = next;
  }
  if (!clause.state.empty() && language_.wanted_by_state(clause.state) != Frame::kNone &&
      clause.mood != Mood::kStatement) {
    // "do not leave the tap on" wants it off
    if (clause.mood == Mood::kForbidden) {
      if (const std::string opposite = language_.opposite_state(clause.state); !opposite.empty())
        clause.state = opposite, clause.mood = Mood::kCommand;
    }
    clause.frame = language_.wanted_by_state(clause.state);
    clause.verb = clause.state;
  }
  add(std::move(clause));
  return i;
}

std::size_t ClauseParser::argument(std::size_t i, std::size_t end, Clause& clause, Role& role, Where& where) {
  const std::string& word = words_[i];
  const auto state_here = [&] {
    return takes_state(clause.frame) && !clause.phrases.empty() &&
           language_.wanted_by_state(word) != Frame::kNone &&
           !((place_preposition(word) || word == "off") && reader_.starts(i + 1, end)) &&
           reader_.name_length(i) == 0;
  };
  if (state_here() &&
      !(word == "on" && clause.frame == Frame::kPlace && clause.verb != "leave" && clause.verb != "keep") &&
      !((word == "off") && clause.verb != "leave" && clause.verb != "keep" && !clause.wish &&
        clause.verb != "get" && clause.verb != "want")) {
    clause.state = word;
    return i + 1;
  }
  if ((clause.wish || clause.frame == Frame::kTake || clause.frame == Frame::kMake) &&
      !clause.phrases.empty() && language_.verb(word) != Frame::kNone && language_.participle(word) &&
      reader_.name_length(i) == 0) {
    clause.frame = language_.verb(word);  // "I want the plates washed"
    clause.verb = language_.verb_base(word);
    return i + 1;
  }
  if (one_of(word, kParticles) &&
      !(one_of(word, kParticles) && place_preposition(word) && reader_.starts(i + 1, end) &&
        !(clause.first(Role::kDirect) == nullptr && (word == "on" || word == "over")))) {
    if (const std::size_t done = particle(i, end, clause, role); done != i) return done;
  }
  if (word == "on" && clause.first(Role::kDirect) == nullptr &&
      (clause.frame == Frame::kTurn || clause.frame == Frame::kStart || clause.frame == Frame::kPlace)) {
    clause.particles.push_back(word);
    return i + 1;
  }
  // "give the mug a wash"
  if (word == "a" && clause.frame == Frame::kTake && !clause.phrases.empty() && i + 1 < end) {
    std::size_t k = i + 1;
    while (k + 1 < end &&
           (words_[k] == "quick" || words_[k] == "good" || words_[k] == "nice" || words_[k] == "little"))
      ++k;
    const Frame noun = language_.verb(words_[k]);
    if ((noun == Frame::kWash || noun == Frame::kHeat) && reader_.name_length(k) == 0) {
      clause.frame = noun, clause.verb = language_.verb_base(words_[k]), clause.to_person = false;
      return k + 1;
    }
  }
  if (Where there_where = Where::kTo;
      i + 1 < end && words_[i + 1] == "there" && place_preposition(word, &there_where)) {
    NounPhrase there;
    there.role = Role::kDestination, there.pronoun = true, there.word = "there", there.where = there_where;
    clause.phrases.push_back(there);
    return i + 2;
  }
  if (word == "there" && (clause.frame == Frame::kPlace || clause.frame == Frame::kBring)) {
    NounPhrase there;
    there.role = Role::kDestination, there.pronoun = true, there.word = word;
    clause.phrases.push_back(there);
    return i + 1;
  }
  // "open the microwave and put the mug inside"
  if ((word == "inside" || word == "in") && !reader_.starts(i + 1, end) && !clause.phrases.empty() &&
      clause.first(Role::kDestination) == nullptr &&
      (clause.frame == Frame::kPlace || clause.frame == Frame::kBring || clause.frame == Frame::kInsert)) {
    NounPhrase it;
    it.role = Role::kDestination, it.where = Where::kIn, it.pronoun = true, it.word = "it";
    clause.phrases.push_back(it);
    return i + 1;
  }
  if (word == "here") {
    clause.to_person = true;
    return i + 1;
  }
  if (word == "from") {
    role = Role::kSource;
    where = Where::kTo;
    NounPhrase phrase;
    std::size_t from = i + 1;
    Where inner = Where::kTo;
    if (from < end && place_preposition(words_[from], &inner) && words_[from] != "to")
      ++from;  // "from inside the fridge"
    const std::size_t done = reader_.read(from, end, phrase, true);
    if (done == from) return i + 1;
    phrase.role = role, phrase.where = inner;
    if (phrase.hand || phrase.person) return done;
    clause.phrases.push_back(std::move(phrase));
    return done;
  }
  if (word == "with" || word == "using" || word == "via") {
    NounPhrase phrase;
    const std::size_t done = reader_.read(i + 1, end, phrase);
    if (done == i + 1) return i + 1;
    // "the cup with coffee"
    if (!adds(clause.frame) && role == Role::kDirect && !clause.phrases.empty() &&
        phrase.adjectives.empty() && phrase.modifier.empty() &&
        language_.content(phrase.phrase) != symbol::kNone &&
        language_.holds_things(clause.phrases.back().phrase) && clause.phrases.back().content.empty()) {
      clause.phrases.back().content = phrase.phrase;
      return done;
    }
    role = Role::kWith;
    phrase.role = role;
    if (!phrase.hand && !phrase.person) clause.phrases.push_back(std::move(phrase));
    return done;
  }
  if (word == "for") {  // for me; for two minutes; for the guests
    NounPhrase phrase;
    std::size_t done = reader_.read(i + 1, end, phrase);
    clause.to_person = clause.to_person || phrase.person;
    if (done == i + 1 && done < end && !opens_command(done, end)) ++done;
    if (done < end && language_.time_unit(words_[done])) ++done;
    return done;
  }
  NounPhrase place;
  if (const std::size_t done = reader_.read_place(i, end, place); done != i) {
    if (place.person || place.hand) {
      clause.to_person = true;
      return done;
    }
    if (place.phrase.empty() && place.unknown && language_.time_unit(place.word))
      return done;  // "in a minute"
    const bool moves =
        word == "to" || word == "into" || word == "onto" || word == "toward" || word == "towards";
    if (locates(clause.frame) && !moves && !place.pronoun && !clause.phrases.empty() &&
        clause.phrases.back().role == Role::kDirect && !clause.phrases.back().pronoun) {
      clause.phrases.back().at.push_back(std::move(place));
      return done;
    }
    role = Role::kDestination, where = place.where;
    place.role = role;
    clause.phrases.push_back(std::move(place));
    return done;
  }
  // a second verb without a join: "turn on the tv put the remote down"
  if (!clause.phrases.empty() && opens_command(i, end) && !language_.participle(word) &&
      language_.wanted_by_state(word) == Frame::kNone)
    return i;
  NounPhrase phrase;
  if (const std::size_t done = reader_.read(i, end, phrase); done != i) {
    // "... the mug it is dirty": a statement begins
    if (!clause.phrases.empty() && done < end && language_.copula(words_[done])) return i;
    if (phrase.person) {
      const bool speaks = words_[i] == "you" && done < end && language_.verb(words_[done]) == Frame::kNone &&
                          !clause.phrases.empty();
      if (speaks && !harmless(done)) return i;
      clause.to_person = true;
      return done;
    }
    phrase.role = role, phrase.where = where;
    if (role == Role::kSource || role == Role::kWith)
      phrase.role = clause.first(Role::kDirect) != nullptr ? role : Role::kDirect;
    // "bring to the table the mug"
    if (role == Role::kDestination && clause.first(Role::kDirect) == nullptr) phrase.role = Role::kDirect;
    clause.phrases.push_back(std::move(phrase));
    return done;
  }
  if (word == "i" || word == "we") return clause.phrases.empty() ? i + 1 : i;  // "... i cannot hear anything"
  if (place_preposition(word) && i + 1 < end && words_[i + 1] != "." && !language_.known(words_[i + 1])) {
    clause.unknown.push_back(words_[i + 1]);
    return i + 2;
  }
  if (!harmless(i) && !place_preposition(word) && !one_of(word, kParticles) && !language_.known(word))
    clause.unknown.push_back(word);
  return i + 1;
}

std::size_t ClauseParser::particle(std::size_t i, std::size_t end, Clause& clause, Role& role) {
  const std::string& word = words_[i];
  const bool noun_next = reader_.starts(i + 1, end);
  if ((word == "out" || word == "off") && i + 1 < end && words_[i + 1] == "of") {
    NounPhrase phrase;
    const std::size_t done = reader_.read(i + 2, end, phrase);
    role = Role::kSource;
    phrase.role = role;
    if (done != i + 2 && !phrase.hand) clause.phrases.push_back(std::move(phrase));
    clause.particles.push_back(word);
    return std::max(done, i + 2);
  }
  // "take the coke off the stove"
  if (word == "off" && noun_next && clause.first(Role::kDirect) != nullptr && clause.frame != Frame::kTurn &&
      clause.frame != Frame::kStop) {
    NounPhrase phrase;
    const std::size_t done = reader_.read(i + 1, end, phrase);
    role = Role::kSource;
    phrase.role = role;
    clause.phrases.push_back(std::move(phrase));
    return done;
  }
  clause.particles.push_back(word);
  return i + 1;
}

ParsedSentence parse_clauses(const Words& words, const Language& language, const Lexicon& lexicon) {
  return ClauseParser(words, language, lexicon).parse();
}

}  // namespace goalnet::inference

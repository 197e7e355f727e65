// Sentences that are no plain commands: statements, wishes, fragments, questions.
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kSpeakers = {"i"sv,  "we"sv,       "you"sv,     "he"sv,     "she"sv,
                                  "im"sv, "somebody"sv, "someone"sv, "nobody"sv, "everyone"sv};
constexpr std::array kDesire = {"better"sv,  "go"sv,       "goes"sv, "goe"sv,  "belong"sv,
                                "belongs"sv, "should"sv,   "must"sv, "need"sv, "ought"sv,
                                "want"sv,    "supposed"sv, "shall"sv};

}  // namespace

std::size_t ClauseParser::statement(std::size_t at, std::size_t end) {
  std::size_t i = at;
  bool negative = false, desired = ensured_;
  const bool there = words_[i] == "there" || words_[i] == "here";
  const std::size_t count = result_.clauses.size();
  if (there && i + 2 < end && words_[i + 1] == "should" && words_[i + 2] == "be" && !ensured_) {
    // "there should be a beer on the shelf": mostly tells where it is
    ensured_ = true;
    const std::size_t done = statement(i + 3 < end ? i + 3 : i, end);
    ensured_ = false;
    for (std::size_t k = count; k < result_.clauses.size(); ++k)
      if (result_.clauses[k].mood == Mood::kCommand)
        result_.clauses[k].mood = Mood::kStatement, result_.clauses[k].wish = true;
    return done;
  }
  if (there) {
    ++i;
    for (; i < end && language_.copula(words_[i]); ++i) desired = desired || one_of(words_[i], kDesire);
  }
  if (words_[at] == "nothing" || words_[at] == "no") {  // "nothing should be standing on the stove"
    std::size_t k = at + 1;
    bool wanted = false;
    for (; k < end && !language_.joins(words_[k]); ++k) {
      wanted = wanted || one_of(words_[k], kDesire);
      NounPhrase place;
      const std::size_t done = wanted ? reader_.read_place(k, end, place) : k;
      if (done == k) continue;
      Clause clause;
      clause.frame = Frame::kClear, clause.verb = "clear";
      clause.phrases.push_back(std::move(place));
      clause.phrases.back().role = Role::kSource;
      add(std::move(clause));
      return done;
    }
    if (at + 1 < end && reader_.name_length(at + 1) > 0) {  // "no tv tonight"
      add_told(at + 1, part_end(at, end));
      return part_end(at, end);
    }
  }
  if (one_of(words_[i < end ? i : at], kSpeakers) || language_.wish(words_[i < end ? i : at]) != nullptr) {
    // "I am thirsty", "you left the tap on", "somebody spilled the coffee"
    const std::size_t stop = skip_part(i, end);
    for (std::size_t k = i; k < stop; ++k) {
      if (const auto* wish = language_.wish(words_[k])) {
        Words words;
        words.text = *wish;
        words.plural.assign(words.text.size(), false);
        for (Clause& clause : ClauseParser(words, language_, *lexicon_).parse().clauses) {
          clause.mood = Mood::kStatement, clause.wish = true;
          add(std::move(clause));
        }
        return stop;
      }
    }
    for (std::size_t k = i + 1; k < stop; ++k) {
      if (words_[k] == "can" || words_[k] == "could" || words_[k] == "not" || words_[k] == "will") continue;
      if ((words_[k] == "forgot" || words_[k] == "forget" || words_[k] == "forgotten") && k + 2 < end &&
          words_[k + 1] == "to" && opens_command(k + 2, end)) {
        const std::size_t done = command(k + 2, end, Mood::kStatement);
        result_.clauses.back().wish = true;
        return done;
      }
      if (words_[k] == "and" && starts_clause(skip_joins(k, end), end)) return k;
      if (opens_command(k, end) &&
          (language_.verb_base(words_[k]) == "leave" || language_.participle(words_[k]) ||
           language_.verb(words_[k]) != Frame::kNone))
        return command(k, end, Mood::kStatement);
      NounPhrase named;
      if (const std::size_t done = reader_.read(k, stop, named); done != k && !named.phrase.empty()) {
        Clause clause;
        clause.mood = Mood::kStatement;
        clause.phrases = {named};
        add(std::move(clause));
        return predicate(done, end, result_.clauses.back(), false, false);
      }
    }
    Clause clause;
    clause.mood = Mood::kStatement;
    add(std::move(clause));
    return stop;
  }
  // "louder please"
  if (const Frame sound = i < end ? language_.wanted_by_state(words_[i]) : Frame::kNone;
      sound == Frame::kRaise || sound == Frame::kLower) {
    Clause clause;
    clause.frame = sound, clause.verb = words_[i];
    clause.phrases.emplace_back();
    clause.phrases.back().phrase = clause.phrases.back().word = "volume";
    add(std::move(clause));
    return i + 1;
  }
  NounPhrase subject;
  const std::size_t named = reader_.read(i, end, subject);
  if (named == i || subject.person) {
    if (i < end && !harmless(i)) result_.stray.push_back(words_[i]);
    // "hey rosie, ...": what somebody is called
    const bool name_of_somebody = i + 1 < end && words_[i + 1] == "," && !language_.known(words_[i]);
    if (name_of_somebody) result_.stray.pop_back();
    return i + 1;
  }
  i = named;
  // "the stuff on the stove has to go", "the pillow from the shelf should go on the chair"
  for (NounPhrase place; i < end; place = {}) {
    const std::size_t from = words_[i] == "from" ? i + 1 : i;
    const std::size_t done =
        from > i ? reader_.read(from, end, place, true) : reader_.read_place(i, end, place);
    if (done == from || place.person || place.hand || done >= end ||
        !(language_.copula(words_[done]) || one_of(words_[done], kDesire) || words_[done] == "can" ||
          words_[done] == "may"))
      break;
    subject.at.push_back(std::move(place));
    i = done;
  }
  std::vector<NounPhrase> subjects = {subject};
  for (std::size_t next = i; next + 1 < end && (words_[next] == "and" || words_[next] == ",");) {
    NounPhrase more;  // "xbox and controller belong on the table"
    const std::size_t done = reader_.read(next + 1, end, more);
    if (done == next + 1 || more.person || more.unknown || done >= end) break;
    subjects.push_back(more);
    next = done;
    if (language_.copula(words_[done]) || one_of(words_[done], kDesire)) i = done;
  }
  if (i == named || !(language_.copula(words_[i]) || one_of(words_[i], kDesire))) subjects.resize(1);
  // "there is a book on the table that belongs on the shelf"
  if (there && i + 1 < end && (words_[i] == "that" || words_[i] == "which") && one_of(words_[i + 1], kDesire))
    ++i;
  // "my coffee has gone cold", "the tv should be on", "that book should not be on the table"
  std::size_t k = i;
  bool verb_seen = there;
  for (; k < end; ++k) {
    const std::string& word = words_[k];
    if (one_of(word, kDesire)) {
      desired = verb_seen = true;
    } else if (word == "not" || word == "never") {
      negative = true;
    } else if (language_.copula(word) || word == "can" || word == "may") {
      verb_seen = true;
    } else if (!(word == "to" && desired) &&
               !(harmless(k) && verb_seen && !reader_.starts(k, end) &&
                 language_.wanted_by_state(word) == Frame::kNone && !place_preposition(word))) {
      break;
    }
  }
  if (!verb_seen) return fragment(at, end);
  Clause clause;
  clause.mood = Mood::kStatement;
  clause.phrases = subjects;
  clause.phrases.front() = subject;
  clause.negative = negative;
  add(std::move(clause));
  if (desired && !negative && k > 0 && (k >= end || language_.joins(words_[k])) &&
      (words_[k - 1] == "go" || words_[k - 1] == "goe") && !subject.at.empty()) {  // "... has to go"
    Clause& last = result_.clauses.back();
    last.mood = Mood::kCommand, last.frame = Frame::kClear, last.verb = "clear";
    return k;
  }
  return predicate(k, end, result_.clauses.back(), desired, negative);
}

// What is said of the subject, from `at` on. `clause` is the last of the result.
std::size_t ClauseParser::predicate(std::size_t at, std::size_t end, Clause& clause, bool desired,
                                    bool negative) {
  std::size_t i = at;
  while (i < end && !language_.joins(words_[i])) {
    const std::string& word = words_[i];
    NounPhrase place;
    if (const std::size_t done = reader_.read_place(i, end, place); done != i && !place.person) {
      if (desired && negative) {  // should not be there: take it away
        clause.mood = Mood::kCommand, clause.frame = Frame::kTake, clause.verb = "take";
        place.role = Role::kSource;
        clause.phrases.push_back(place);
      } else if (desired) {
        clause.mood = Mood::kCommand, clause.frame = Frame::kPlace, clause.verb = "put";
        place.role = Role::kDestination;
        clause.phrases.push_back(place);
      } else if (place.phrase == "channel" && place.number > 0) {  // "my show is on channel 2"
        clause.frame = Frame::kChange, clause.verb = "change", clause.wish = true;
        place.role = Role::kDirect;
        clause.phrases = {place};
      } else if (!clause.phrases.empty()) {
        clause.phrases.front().at.push_back(place);
      }
      i = done;
      continue;
    }
    if (language_.verb(word) != Frame::kNone && (language_.participle(word) || desired) &&
        language_.wanted_by_state(word) == Frame::kNone) {
      if (!desired) {
        clause.state = word;
        ++i;
        continue;
      }
      clause.mood = negative ? Mood::kForbidden : Mood::kCommand;
      clause.frame = language_.verb(word), clause.verb = language_.verb_base(word);
      Role role = Role::kDirect;
      Where where = Where::kTo;
      for (++i; i < end && !language_.joins(words_[i]);) {
        clause.words.push_back(words_[i]);
        const std::size_t next = argument(i, end, clause, role, where);
        if (next == i) break;
        i = next;
      }
      return i;
    }
    if (clause.state.empty() &&
        (language_.wanted_by_state(word) != Frame::kNone || language_.complaint(word) != Frame::kNone)) {
      clause.state = word;
      std::string wanted = word;
      if (desired && negative) wanted = language_.opposite_state(word);
      if (desired && !wanted.empty() && language_.wanted_by_state(wanted) != Frame::kNone) {
        clause.mood = Mood::kCommand;
        clause.frame = language_.wanted_by_state(wanted), clause.verb = wanted;
        clause.state = wanted;
      }
      ++i;
      if (clause.mood == Mood::kCommand && i < end && words_[i] == "of") {  // "should be full of water"
        NounPhrase content;
        const std::size_t done = reader_.read(i + 1, end, content);
        content.role = Role::kWith;
        if (done != i + 1) clause.phrases.push_back(content), i = done;
      }
      continue;
    }
    if (NounPhrase content;
        desired && !negative && clause.mood == Mood::kStatement) {  // "should have water in it"
      const std::size_t done = reader_.read(i, end, content);
      if (done != i && language_.content(content.phrase) != symbol::kNone) {
        clause.mood = Mood::kCommand, clause.frame = Frame::kFill, clause.verb = "fill";
        content.role = Role::kWith;
        clause.phrases.push_back(content);
        i = done;
        if (i + 1 < end && (words_[i] == "in" || words_[i] == "inside") && words_[i + 1] == "it") i += 2;
        continue;
      }
    }
    // "every armchair should have a pillow on it", "every cup needs a spoon in it"
    if (NounPhrase thing;
        desired && !negative && clause.mood == Mood::kStatement && !clause.phrases.empty()) {
      const std::size_t done = reader_.read(i, end, thing);
      NounPhrase on_it;
      const std::size_t after = done == i ? i : reader_.read_place(done, end, on_it);
      if (done != i && after != done && on_it.pronoun && !thing.pronoun && !thing.person && !thing.unknown) {
        NounPhrase holder = clause.phrases.front();
        holder.role = Role::kDestination, holder.where = on_it.where;
        clause.mood = Mood::kCommand, clause.frame = Frame::kPlace, clause.verb = "put";
        clause.phrases = {thing, holder};
        i = after;
        continue;
      }
    }
    // a new command without a join: "i cannot see it turn on the tv"
    if (opens_command(i, end) && i > at) return i;
    ++i;
  }
  return i;
}

// "... And a pillow.", "the other plate too": what was asked before is asked of this as well.
bool ClauseParser::again(const Clause& fragment) {
  if (result_.clauses.empty() || result_.clauses.back().mood != Mood::kCommand) return false;
  Clause same = result_.clauses.back();
  std::erase_if(same.phrases, [](const NounPhrase& phrase) {
    return phrase.role == Role::kDirect || phrase.role == Role::kSource;
  });
  same.phrases.insert(same.phrases.begin(), fragment.phrases.begin(), fragment.phrases.end());
  add(std::move(same));
  return true;
}

// "spoon in sink", "tap on please", "volume down", "channel 5", "the mug please".
std::size_t ClauseParser::fragment(std::size_t at, std::size_t end) {
  Clause clause;
  clause.frame = Frame::kNone;
  NounPhrase subject;
  std::size_t i = reader_.read(at, end, subject);
  clause.phrases = {subject};
  for (std::size_t k = at; k < i; ++k) clause.words.push_back(words_[k]);
  while (i < end && language_.joins(words_[i])) {  // "plates and cups in the sink"
    NounPhrase more;
    const std::size_t next = skip_joins(i, end), done = reader_.read(next, end, more);
    if (done == next || starts_clause(next, end)) break;
    more.alternative = words_[i] == "or";  // "coke or beer please"
    clause.phrases.push_back(more);
    i = done;
  }
  while (i < end && words_[i] == "from") {  // "pillow from armchair 2 to the couch"
    NounPhrase source;
    const std::size_t done = reader_.read(i + 1, end, source, true);
    if (done == i + 1 || source.person || source.unknown) break;
    for (NounPhrase& phrase : clause.phrases) phrase.at.push_back(source);
    i = done;
  }
  NounPhrase place;
  bool polite = false;
  for (const std::string& word : words_)
    polite =
        polite || word == "please" || word == "now" || word == "quick" || word == "asap" || word == "thank";
  const auto only_harmless_from = [&](std::size_t from) {
    std::size_t k = from;
    if (NounPhrase purpose; k < end && words_[k] == "for") {
      k = std::max(reader_.read(k + 1, end, purpose), k + 1);
      polite = polite || purpose.person;
    }
    for (; k < end && !language_.joins(words_[k]); ++k) {
      if (!harmless(k)) return false;
      polite = polite || words_[k] == "please" || words_[k] == "me" || words_[k] == "us";
    }
    if (k + 1 < end && words_[k] == "," && words_[k + 1] == "please") polite = true;
    return true;
  };
  if (subject.unknown) {
    result_.stray.push_back(subject.word);
    return std::max(i, at + 1);
  }
  if (i < end && (words_[i] == "on" || words_[i] == "off" || words_[i] == "up" || words_[i] == "down") &&
      !reader_.starts(i + 1, end)) {
    clause.frame = Frame::kTurn, clause.verb = "turn";
    clause.particles = {words_[i]};
    clause.words.push_back(words_[i]);
    add(std::move(clause));
    return i + 1;
  }
  // "water in": into what was spoken of
  if (i < end && (words_[i] == "in" || words_[i] == "into") &&
      (i + 1 >= end || language_.joins(words_[i + 1]))) {
    clause.frame = Frame::kPlace, clause.verb = "put";
    clause.particles = {"in"};
    add(std::move(clause));
    return i + 1;
  }
  // "coke in there too"
  if (i + 1 < end && words_[i + 1] == "there" && place_preposition(words_[i], &place.where)) {
    clause.frame = Frame::kPlace, clause.verb = "put";
    place.role = Role::kDestination, place.pronoun = true, place.word = "there";
    clause.phrases.push_back(place);
    add(std::move(clause));
    return i + 2;
  }
  if (i + 1 < end && words_[i] == "off") {  // "everything off the stove"
    const std::size_t done = reader_.read(i + 1, end, place, true);
    if (done != i + 1 && !place.unknown && !place.person) {
      clause.frame = Frame::kTake, clause.verb = "take";
      place.role = Role::kSource;
      clause.phrases.push_back(place);
      add(std::move(clause));
      return done;
    }
    place = {};
  }
  if (i + 1 < end && words_[i] == "for") {  // "a pillow for every armchair"
    const std::size_t done = reader_.read(i + 1, end, place, true);
    if (done != i + 1 && place.all && lexicon_->is_place_name(place.phrase)) {
      clause.frame = Frame::kPlace, clause.verb = "put";
      place.role = Role::kDestination, place.where = Where::kOn;
      clause.phrases.push_back(place);
      add(std::move(clause));
      return done;
    }
    place = {};
  }
  if (const std::size_t done = reader_.read_place(i, end, place); done != i && !place.person) {
    clause.frame = Frame::kPlace, clause.verb = "put";
    std::size_t last = done;
    NounPhrase second;  // "everything on the counter into the sink"
    if (const std::size_t after = reader_.read_place(done, end, second); after != done) {
      for (NounPhrase& phrase : clause.phrases) phrase.at.push_back(place);
      place = second, last = after;
    }
    place.role = Role::kDestination;
    clause.phrases.push_back(place);
    add(std::move(clause));
    return last;
  }
  if (i < end && language_.wanted_by_state(words_[i]) != Frame::kNone) {
    clause.frame = language_.wanted_by_state(words_[i]), clause.verb = clause.state = words_[i];
    add(std::move(clause));
    return i + 1;
  }
  if (subject.phrase == "channel" && (subject.has("next") || subject.has("previous"))) {
    clause.frame = Frame::kChange, clause.verb = "change";
    add(std::move(clause));
    return i;
  }
  if (language_.tv_word(subject.phrase) && (subject.number > 0 || subject.ordinal > 0)) {
    clause.frame = Frame::kChange, clause.verb = "change";
    add(std::move(clause));
    return i;
  }
  if (!subject.modifier.empty() && only_harmless_from(i)) {  // "plates sink"
    clause.frame = Frame::kPlace, clause.verb = "put";
    add(std::move(clause));
    return i;
  }
  // "the other plate too"
  if (i < end && words_[i] == "too" && ends_here(i, end) && again(clause)) return i + 1;
  if (only_harmless_from(i) && polite) {
    clause.frame = Frame::kTake, clause.verb = "bring", clause.to_person = true;
    add(std::move(clause));
    return i;
  }
  if (ends_here(i, end) && again(clause)) {
    while (i < end && words_[i] != ",") ++i;
    return i;
  }
  result_.stray.push_back(words_[at]);
  return std::max(i, at + 1);
}

// "why is the salt on the stove": nothing to do, but "it" means the salt from here on.
std::size_t ClauseParser::question(std::size_t at, std::size_t end) {
  Clause clause;
  clause.mood = Mood::kQuestion;
  std::size_t i = at + 1;
  while (i < end && !language_.joins(words_[i])) {
    NounPhrase phrase;
    std::size_t done = reader_.read_place(i, end, phrase);
    const bool place = done != i;
    if (!place) done = reader_.read(i, end, phrase);
    const bool first_thing = clause.first(Role::kDirect) == nullptr;
    if (done != i && !phrase.person && !phrase.unknown && !phrase.phrase.empty() && (place || first_thing)) {
      phrase.role = place ? Role::kDestination : Role::kDirect;
      clause.phrases.push_back(phrase);
    }
    i = std::max(done, i + 1);
  }
  add(std::move(clause));
  return i;
}

}  // namespace goalnet::inference

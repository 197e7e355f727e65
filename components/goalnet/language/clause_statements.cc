// Sentences that are no plain commands: statements, wishes, questions.
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

constexpr std::array kSpeakers = {"i"sv,  "we"sv,       "you"sv,     "he"sv,     "she"sv,     "whoever"sv,
                                  "im"sv, "somebody"sv, "someone"sv, "nobody"sv, "everyone"sv};

}  // namespace

std::size_t ClauseParser::statement(std::size_t at, std::size_t end) {
  std::size_t i = at;
  bool negative = false, desired = ensured_;
  const bool there = words_[i] == "there" || words_[i] == "here";
  const std::size_t count = result_.clauses.size();
  if (there && i + 2 < end && words_[i + 2] == "be" && !ensured_ &&
      (words_[i + 1] == "should" || (words_[i + 1] == "must" && language_.hears_people()))) {
    // "there should be a beer on the shelf": mostly tells where it is
    ensured_ = true;
    const std::size_t done = statement(i + 3 < end ? i + 3 : i, end);
    ensured_ = false;
    for (std::size_t k = count; k < result_.clauses.size(); ++k) {
      result_.clauses[k].supposed = true;
      if (result_.clauses[k].mood == Mood::kCommand)
        result_.clauses[k].mood = Mood::kStatement, result_.clauses[k].wish = true;
    }
    return done;
  }
  if (there)
    if (const std::size_t done = there_is_no(at, end); done != at) return done;
  if (there) {
    ++i;
    for (; i < end && language_.copula(words_[i]); ++i) desired = desired || one_of(words_[i], kDesire);
  }
  if (judging_)
    if (const std::size_t done = is_anything(at, end); done != at) return done;
  if (const std::size_t done = nothing_should(at, end); done != at) return done;
  static constexpr std::array kHave = {"left"sv, "have"sv, "has"sv, "had"sv, "forgot"sv};
  bool somebody = false;  // "the children have left the television running"
  if (NounPhrase who; language_.hears_people() && i < end) {
    const std::size_t done = reader_.read(i, end, who);
    somebody = done != i && who.person && done + 1 < end && one_of(words_[done], kHave) &&
               std::any_of(words_.begin() + static_cast<long>(done),
                           words_.begin() + static_cast<long>(part_end(i, end)),
                           [&](const std::string& word) { return language_.verb_base(word) == "leave"; });
    if (somebody) i = done - 1;
  }
  if (somebody || one_of(words_[i < end ? i : at], kSpeakers) ||
      language_.wish(words_[i < end ? i : at]) != nullptr) {
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
  if (const std::size_t stop = part_end(at, end);
      language_.hears_people() && !ensured_ && named == i && tells(at, stop) && !language_.asks(words_[at])) {
    result_.passed.push_back(words_[at]);  // "three is broken"
    add_told(at, stop);
    return stop;
  }
  if (named == i || subject.person) {
    if (i < end && !harmless(i)) result_.stray.push_back(words_[i]);
    // "hey rosie, ...": what somebody is called
    const bool name_of_somebody = i + 1 < end && words_[i + 1] == "," && !language_.known(words_[i]);
    if (name_of_somebody) result_.stray.pop_back();
    return i + 1;
  }
  i = named;
  if (language_.hears_people() && i + 1 < end && is_pronoun(words_[i]) &&
      (one_of(words_[i + 1], kDesire) || language_.copula(words_[i + 1])))
    ++i;  // "the mug it must be put into the sink"
  // "the stuff on the stove has to go", "the pillow from the shelf should go on the chair"
  for (NounPhrase place; i < end; place = {}) {
    const std::size_t from = words_[i] == "from" ? i + 1 : i;
    const std::size_t done =
        from > i ? reader_.read(from, end, place, true) : reader_.read_place(i, end, place);
    if (done == from || place.person || place.hand || done >= end ||
        !(language_.copula(words_[done]) || one_of(words_[done], kDesire) || words_[done] == "can" ||
          words_[done] == "may" ||
          (there && words_[done] == "that" && language_.hears_people() && done + 1 < end &&
           one_of(words_[done + 1], kDesire))))
      break;
    subject.at.push_back(std::move(place));
    i = done;
  }
  i = from_several(i, end, subject);
  NounPhrase left_out;
  i = subject_but(i, end, subject, left_out);
  std::vector<NounPhrase> subjects = {subject};
  for (std::size_t next = i; next + 1 < end && (words_[next] == "and" || words_[next] == ",");) {
    NounPhrase more;  // "xbox and controller belong on the table"
    const std::size_t done = reader_.read(next + 1, end, more);
    const bool last_there = there && language_.hears_people() && done == end;
    if (done == next + 1 || more.person || more.unknown || (done >= end && !last_there)) break;
    subjects.push_back(more);
    next = done;
    if (last_there) break;
    const bool pause = language_.hears_people() && words_[done] == "," && done + 1 < end;
    const std::size_t verb = pause ? done + 1 : done;  // "every can - coke, beer - should be in the fridge"
    if (language_.copula(words_[verb]) || one_of(words_[verb], kDesire)) i = verb;
  }
  const bool listed = subjects.size() > 2 && subjects.front().all && words_[named] == ",";
  if (language_.hears_people() && listed && i != named) {  // "all the dishes - mug, glass, bowl - ..."
    subjects.erase(subjects.begin());
    subject = subjects.front();
  }
  if (left_out.role == Role::kExcept) subjects.push_back(std::move(left_out));
  const bool all_there = there && language_.hears_people() && subjects.size() > 1 &&
                         i == named;  // "there is the beer and the coke"
  if (!all_there && (i == named || !(language_.copula(words_[i]) || one_of(words_[i], kDesire))))
    subjects.resize(1);
  // "there is a book on the table that belongs on the shelf"
  if (there && i + 1 < end && (words_[i] == "that" || words_[i] == "which") && one_of(words_[i + 1], kDesire))
    ++i;
  // "my coffee has gone cold", "the tv should be on", "that book should not be on the table"
  std::size_t k = i;
  bool verb_seen = there, supposed = false;
  static constexpr std::array kSupposes = {"should"sv, "must"sv, "ought"sv};
  for (; k < end; ++k) {
    const std::string& word = words_[k];
    if (one_of(word, kDesire)) {
      supposed = supposed || one_of(word, kSupposes);
      desired = verb_seen = true;
    } else if (word == "not" || word == "never") {
      negative = true;
    } else if (language_.copula(word) || word == "can" || word == "may" ||
               (word == "might" && language_.hears_people())) {
      // "the bag can be thrown away", "the mug can go in the sink"
      static constexpr std::array kAllows = {"can"sv, "could"sv, "may"sv, "might"sv};
      static constexpr std::array kHappens = {"be"sv,  "go"sv,    "come"sv, "get"sv,
                                              "sit"sv, "stand"sv, "live"sv};
      const bool question = at > 0 && one_of(words_[at - 1], kAllows);
      if (language_.hears_people() && one_of(word, kAllows) && k + 1 < end &&
          one_of(words_[k + 1], kHappens) && !question)
        desired = true;
      verb_seen = true;
    } else if (!(word == "to" && desired && !reader_.starts(k + 1, end)) &&
               !(harmless(k) && verb_seen && !reader_.starts(k, end) &&
                 language_.wanted_by_state(word) == Frame::kNone && !place_preposition(word) &&
                 !(language_.hears_people() &&
                   (word == "free" || word == "with" ||
                    (word == "no" && k + 1 < end && reader_.name_length(k + 1) > 0))))) {
      break;
    }
  }
  if (language_.hears_people() && desired && k < end && (words_[k] == "come" || words_[k] == "move"))
    verb_seen = true;  // "could the plate come down from the shelf?"
  if (!verb_seen) return fragment(at, end);
  Clause clause;
  clause.mood = Mood::kStatement;
  static constexpr std::array kShows = {"has"sv, "have"sv, "show"sv, "play"sv};
  if (language_.hears_people() && subject.phrase == "channel" && subject.number > 0 && !negative &&
      named < end &&
      one_of(words_[named], kShows)) {  // "channel one has the news": like "the news is on ..."
    clause.frame = Frame::kChange, clause.verb = "change", clause.wish = true;
    clause.phrases = {subject};
    add(std::move(clause));
    return part_end(k, end);
  }
  clause.phrases = subjects;
  clause.phrases.front() = subject;
  clause.negative = negative, clause.supposed = supposed;
  add(std::move(clause));
  if (desired && !negative && k > 0 && (k >= end || language_.joins(words_[k])) &&
      (words_[k - 1] == "go" || words_[k - 1] == "goe") && !subject.at.empty()) {  // "... has to go"
    Clause& last = result_.clauses.back();
    last.mood = Mood::kCommand, last.frame = Frame::kClear, last.verb = "clear";
    return k;
  }
  return predicate(k, end, result_.clauses.back(), desired, negative);
}

}  // namespace goalnet::inference

// Parts of a sentence that only tell something: "my back is killing me", "the kids left a mess on the couch",
// "bedtime, kids!". Where the grammar cannot read them they are passed over, if something else is asked for.
#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

constexpr std::size_t kLongestTold = 5;

}  // namespace

// Where the part that begins at `at` ends: at a comma, or where "and", "so", "but" begin a command.
std::size_t ClauseParser::part_end(std::size_t at, std::size_t end) const {
  for (std::size_t i = at; i < end; ++i) {
    const std::string& word = words_[i];
    if (word == ",") return i;
    if (language_.hears_people() && i > at && word == "wish" && words_[i - 1] != "not" &&
        words_[i - 1] != "i" && words_[i - 1] != "we")
      return i;  // "for dessert I want two scoops"
    if (language_.hears_people() && word == "but" && i > at && words_[i - 1] == "nothing") continue;
    if (i == at || (word != "and" && word != "so" && word != "but" && word != "then")) continue;
    const std::size_t next = skip_joins(i + 1, end);
    if (next + 1 < end && words_[next] == "there" && language_.copula(words_[next + 1])) return i;
    if (next < end && (opens_command(next, end) || words_[next] == "wish" || words_[next] == "not")) return i;
    if (NounPhrase subject; language_.hears_people() && next < end) {  // "..., so the bag can be thrown away"
      static constexpr std::array kModals = {"can"sv,  "could"sv, "may"sv, "should"sv,
                                             "must"sv, "need"sv,  "has"sv, "belong"sv};
      std::size_t done = reader_.read(next, end, subject);
      for (NounPhrase more; done != next && done + 1 < end && words_[done] == "and"; more = {}) {
        const std::size_t after =
            reader_.read(done + 1, end, more);  // "so both plates and the bowl need ..."
        if (after == done + 1 || more.person || more.unknown) break;
        done = after;
      }
      if (done != next && !subject.person && !subject.unknown && done < end && one_of(words_[done], kModals))
        return i;
      // "he played with the knobs and two burners are on"
      if (done != next && !subject.person && !subject.unknown && done + 1 < end &&
          (words_[done] == "is" || words_[done] == "are") && word == "and" &&
          (language_.wanted_by_state(words_[done + 1]) != Frame::kNone ||
           language_.complaint(words_[done + 1]) != Frame::kNone))
        return i;
    }
  }
  return end;
}

// Whether the words begin with a subject and go on with a verb, as no command does.
bool ClauseParser::tells(std::size_t at, std::size_t stop) const {
  const std::string& first = words_[at];
  const bool pointer = one_of(first, kPointers) && reader_.starts(at + 1, stop);  // "that bowl too"
  if ((one_of(first, kSubjects) && !pointer) || language_.wish(first) != nullptr) return stop > at + 1;
  // the subject: "my back", "the kids", "guests", "half the family"
  for (std::size_t i = at + 1; i < stop && i <= at + kLongestTold; ++i) {
    if (const std::size_t name = reader_.name_length(i); name > 1) {
      i += name - 1;  // "dry" of "the canada dry" is no verb
      continue;
    }
    const std::string& word = words_[i];
    if (language_.copula(word) || word == "not") return true;
    if (word == "please" || (language_.hears_people() && word == "except")) continue;
    if (word.size() > 4 && word.ends_with("ed") && reader_.name_length(i) == 0) return true;  // "beeped"
    if (does_often(at, i)) return true;
    const bool noun_before = !one_of(words_[i - 1], kDeterminers) && !one_of(words_[i - 1], kArticles) &&
                             !place_preposition(words_[i - 1]);
    if (noun_before && reader_.name_length(i) == 0 && language_.english_verb(word) &&
        !place_preposition(word))
      return true;
  }
  return false;
}

// "my kid only drinks from the glass": behind a person and such an adverb a name is a verb.
bool ClauseParser::does_often(std::size_t at, std::size_t verb) const {
  static constexpr std::array kOften = {"only"sv, "always"sv, "never"sv, "just"sv, "also"sv, "still"sv};
  if (!language_.hears_people() || verb <= at || verb >= words_.size() || !one_of(words_[verb - 1], kOften))
    return false;
  std::size_t who = verb - 1;
  while (who > at && one_of(words_[who], kOften)) --who;
  return language_.person(words_[who]) && language_.english_verb(words_[verb]);
}

// Notes what the part speaks of, so that "it" and "there" may mean that.
void ClauseParser::add_told(std::size_t at, std::size_t stop) {
  Clause clause;
  clause.mood = Mood::kStatement;
  std::size_t thing_end = SIZE_MAX;
  for (std::size_t i = at; i < stop;) {
    if (does_often(at, i + 1)) i += 2;
    NounPhrase phrase;
    std::size_t done = reader_.read_place(i, stop, phrase);
    const bool place = done != i;
    if (!place) done = reader_.read(i, stop, phrase);
    if (done != i && phrase.phrase == "channel" && phrase.number > 0 && !clause.wish) {
      clause.frame = Frame::kChange, clause.verb = "change", clause.wish = true;  // "my show is on channel 4"
      phrase.role = Role::kDirect;
      clause.phrases = {std::move(phrase)};
    } else if (done != i && !phrase.person && !phrase.unknown && !clause.wish &&
               (!phrase.phrase.empty() || (phrase.everything && !phrase.at.empty()))) {
      phrase.role = place ? Role::kDestination : Role::kDirect;
      if (language_.hears_people() && place && thing_end == i && !clause.phrases.empty() &&
          clause.phrases.back().role == Role::kDirect)
        clause.phrases.back().at.push_back(phrase);  // "the book on the couch I have not finished"
      clause.phrases.push_back(std::move(phrase));
    }
    if (!place) thing_end = done;
    i = std::max(done, i + 1);
  }
  add(std::move(clause));
}

std::size_t ClauseParser::told(std::size_t at, std::size_t end) {
  const std::size_t stop = part_end(at, end);
  if (!tells(at, stop)) return at;
  if (const std::string& last = words_[stop - 1];
      language_.hears_people() &&
      (last == "itself" || last == "themselves")) {  // "the noodles will not cook themselves"
    add_told(at, stop);
    return stop;
  }
  // What can be read is read: "the mug should be in the sink" asks for something.
  ClauseParser trial = *this;
  trial.result_ = {};
  trial.insert_before_ = SIZE_MAX;
  const std::size_t done = trial.statement(at, stop);
  bool read = trial.result_.stray.empty() && trial.result_.problem.empty() && !trial.result_.clauses.empty();
  for (const Clause& clause : trial.result_.clauses) {
    read = read && clause.unknown.empty();
    for (const NounPhrase& phrase : clause.phrases) read = read && !phrase.unknown;
  }
  if (!read) {
    add_told(at, stop);
    return stop;
  }
  reader_.recall(trial.reader_);
  const bool placed = language_.hears_people() && !result_.clauses.empty() && result_.clauses.back().belongs;
  for (Clause& clause : trial.result_.clauses) {
    // "the salt goes on the counter, it has no business on the stove": that says why
    if (placed && clause.verb == "take" && clause.first(Role::kSource) != nullptr &&
        clause.phrases.front().pronoun)
      continue;
    add(std::move(clause));
  }
  return std::max(done, at + 1);
}

// "I can't remember if I switched the stove off": says what is not known, and asks for nothing.
std::size_t ClauseParser::does_not_know(std::size_t at, std::size_t end) {
  static constexpr std::array kKnows = {"remember"sv, "recall"sv, "know"sv, "sure"sv,
                                        "certain"sv,  "tell"sv,   "say"sv,  "think"sv};
  const std::size_t stop = part_end(at, end);
  bool denied = false;
  for (std::size_t i = at + 1; i + 1 < stop; ++i) {
    denied = denied || words_[i] == "not" || words_[i] == "never" || words_[i] == "hardly";
    const bool asks = words_[i + 1] == "if" || words_[i + 1] == "whether";
    if (!asks) continue;
    if (!(denied && one_of(words_[i], kKnows)) && words_[i] != "forget" && words_[i] != "forgot") return at;
    add_told(at, stop);
    return stop;
  }
  return at;
}

// "love watching movies"
bool ClauseParser::likes_doing(std::size_t at, std::size_t end) const {
  static constexpr std::array kLikes = {"love"sv, "hate"sv, "enjoy"sv, "prefer"sv, "adore"sv, "miss"sv};
  return language_.hears_people() && at + 1 < end && one_of(words_[at], kLikes) &&
         words_[at + 1].size() > 5 && words_[at + 1].ends_with("ing") && reader_.name_length(at + 1) == 0;
}

// "no time to tidy, ...", "sitting is agony, ...": begins as requests do, but is none.
std::size_t ClauseParser::idle(std::size_t at, std::size_t end) {
  static constexpr std::array kLacks = {"time"sv,   "point"sv,  "use"sv, "sense"sv,
                                        "chance"sv, "wonder"sv, "fun"sv, "rush"sv};
  static constexpr std::array kIs = {"is"sv, "was"sv, "get"sv, "become"sv, "make"sv};
  if (!language_.hears_people() || at + 1 >= end) return at;
  const std::string& word = words_[at];
  if (likes_doing(at, end)) {
    add_told(at, part_end(at, end));
    return part_end(at, end);
  }
  const bool gerund = word.ends_with("ing") && language_.english_verb(word) && reader_.name_length(at) == 0;
  if (const std::size_t stop = part_end(at, end); word == "for" && stop < end && words_[stop] == "wish") {
    for (std::size_t i = at; i < stop; ++i)
      if (reader_.name_length(i) > 0) return at;
    return stop;  // "for dessert I want ..."
  }
  if (word == "i" || word == "we") {  // "I wonder if the tv is on" asks
    if (const std::size_t stop = does_not_know(at, end); stop != at) return stop;
    std::size_t k = at + 1;
    if (words_[k] == "was" || words_[k] == "am" || words_[k] == "were" || words_[k] == "are") ++k;
    if (k + 1 >= end || (words_[k] != "wonder" && words_[k] != "wondering") ||
        (words_[k + 1] != "if" && words_[k + 1] != "whether"))
      return at;
    result_.wonders = true;
    add_told(at, part_end(at, end));
    return part_end(at, end);
  }
  const bool enough =
      word == "enough" && part_end(at, end) < end;  // "enough chips for today, away with them"
  if (!enough && !(word == "no" ? one_of(words_[at + 1], kLacks) : gerund && one_of(words_[at + 1], kIs)))
    return at;
  add_told(at, part_end(at, end));
  return part_end(at, end);
}

}  // namespace goalnet::inference

// A command: a verb, then its things and places to the end of the clause.
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

// Frames whose things stay where they are.
bool puts_nothing(Frame frame) {
  return frame == Frame::kPlay || frame == Frame::kGo || frame == Frame::kMute || frame == Frame::kRaise ||
         frame == Frame::kLower || frame == Frame::kChange || frame == Frame::kTry || frame == Frame::kOpen ||
         frame == Frame::kClose || frame == Frame::kStop || frame == Frame::kStart || frame == Frame::kTurn;
}

}  // namespace

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
  // "I need put the egg on a plate"
  if (clause.wish && language_.hears_people() && opens_command(i, end) && reader_.name_length(i) == 0 &&
      !language_.participle(words_[i]))
    return command(i, end, mood);
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
  // "nothing good on channel three, try four"
  if (clause.frame == Frame::kTry && i < end && number_word(words_[i]) > 0 &&
      std::find(words_.begin(), words_.end(), "channel") != words_.end()) {
    NounPhrase channel;
    channel.phrase = channel.word = "channel", channel.number = number_word(words_[i]);
    clause.frame = Frame::kChange, clause.verb = "change";
    clause.phrases.push_back(std::move(channel));
    ++i;
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
      if (language_.hears_people() && word == "," && one_of(words_[next], kSubjects) &&
          !one_of(words_[next], kPointers) && tells(next, part_end(next, end)) && !is_pronoun(words_[next]))
        break;  // "mute, I am on a call"
      if (NounPhrase thing, there;
          language_.hears_people() && word == "," && clause.phrases.empty() && puts_nothing(clause.frame)) {
        const std::size_t done = reader_.read(next, end, thing);  // "play, xbox on the coffee table"
        if (done != next && reader_.read_place(done, end, there) != done) break;
      }
      if (language_.hears_people() && number_word(words_[next]) > 0 && next + 1 < end &&
          language_.copula(words_[next + 1]))
        break;  // "burner two, three is broken"
      if (NounPhrase with; language_.hears_people() && words_[next] == "with" && !clause.phrases.empty()) {
        const std::size_t done = reader_.read(next + 1, end, with);  // "..., with the beer beside it"
        if (done != next + 1 && !opens_command(done, end)) {
          i = next;
          continue;
        }
      }
      if (language_.hears_people() && word == "," && clause.verb == "leave" && words_[next - 1] == "but")
        break;
      if (word == "," && tells_time(next, part_end(next, end))) break;  // "bring the mug, bus in an hour"
      NounPhrase phrase;
      const std::size_t done = reader_.read(next, end, phrase);
      if (done != next && !clause.phrases.empty()) {
        const std::size_t after = skip_joins(done, end);
        const bool subject =
            one_of(words_[next], kSubjects) || one_of(words_[next], kArticles) || phrase.person;
        if (subject && tells(next, part_end(next, end)) && !reader_.starts(done, end)) break;
        const bool statement_follows = done < end && (language_.copula(words_[done]) || phrase.person);
        if (statement_follows && after == done) break;
        // "a book, the one on the shelf": tells which book
        if (NounPhrase at_place; words_[i] == "," && words_[next] == "the" && words_[next + 1] == "one" &&
                                 ends_here(std::max(done, reader_.read_place(done, end, at_place)), end) &&
                                 !(phrase.at.empty() && at_place.bare()))
          break;
        for (std::size_t k = i; k < next; ++k) phrase.alternative = phrase.alternative || words_[k] == "or";
        for (std::size_t k = i; k < next; ++k)
          if (words_[k] == "except" || words_[k] == "but") phrase.role = Role::kExcept;
        // "take a beer and a coke, both to the table"
        if (NounPhrase there; phrase.pronoun && phrase.plural && words_[i] == "," &&
                              reader_.read_place(done, end, there) != done)
          break;
        // "switch burner 4 off and burner 1 on", "channel 2, volume down"
        const bool has_particle = clause.has_particle("on") || clause.has_particle("off") ||
                                  clause.has_particle("up") || clause.has_particle("down");
        const bool own_particle = done < end && (words_[done] == "on" || words_[done] == "off" ||
                                                 words_[done] == "up" || words_[done] == "down");
        if (own_particle &&
            (done + 1 >= end || language_.joins(words_[done + 1]) || ends_here(done + 1, end)) &&
            (has_particle || clause.frame != Frame::kTurn))
          break;
        // "turn off the tv, books on the shelf": the second part has no verb
        NounPhrase place;
        if (role == Role::kDirect && phrase.role != Role::kExcept && words_[i] == "," &&
            puts_nothing(clause.frame) && reader_.read_place(done, end, place) != done)
          break;
        place = {};
        // "put the mug in the sink and the glass on the counter": the verb counts again
        const bool swaps = language_.hears_people() && clause.frame == Frame::kSwap;
        if (role == Role::kDestination && phrase.role != Role::kExcept && done < end && !swaps &&
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
        NounPhrase there;  // "not the one on the couch"
        const std::size_t after =
            language_.hears_people() && phrase.word == "one" ? reader_.read_place(done, end, there) : done;
        if (after != done) phrase.at.push_back(there);
        clause.phrases.push_back(std::move(phrase));
        i = after;
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
    if (word == "at_later") {  // "turn the tv off at eight"
      for_later();
      ++i;
      continue;
    }
    if (one_of(word, kSubordinate) || one_of(word, kTurns) || word == "not" || word == "never" ||
        word == "wish")
      break;
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
  // "take a cup to the sink, then take the other one too"
  if (language_.hears_people() && !clause.words.empty() && clause.words.back() == "too" &&
      clause.mood == Mood::kCommand && clause.first(Role::kDestination) == nullptr &&
      clause.first(Role::kDirect) != nullptr && !result_.clauses.empty() &&
      (clause.frame == Frame::kTake || clause.frame == Frame::kBring || clause.frame == Frame::kPlace)) {
    const Clause& before = result_.clauses.back();
    const NounPhrase* there = before.mood == Mood::kCommand ? before.first(Role::kDestination) : nullptr;
    const bool same =
        clause.verb == before.verb || clause.verb == "take" || clause.verb == "put" || clause.verb == "move";
    if (same && there != nullptr)
      clause.phrases.push_back(*there), clause.frame = before.frame, clause.verb = before.verb;
  }
  // "the news is on channel 1, put it on"
  if (Clause* told = result_.clauses.empty() ? nullptr : &result_.clauses.back();
      told != nullptr && told->mood == Mood::kStatement && told->frame == Frame::kChange &&
      clause.has_particle("on") && clause.first(Role::kDirect) != nullptr &&
      clause.first(Role::kDirect)->pronoun) {
    told->asked = true;
    return i;
  }
  // "it goes on the shelf, put it back": there, wherever it stood
  const auto last_asked = std::find_if(result_.clauses.rbegin(), result_.clauses.rend(),
                                       [](const Clause& c) { return c.mood == Mood::kCommand; });
  const bool belongs = language_.hears_people() ? last_asked != result_.clauses.rend() && last_asked->belongs
                                                : !result_.clauses.empty() && result_.clauses.back().belongs;
  if (belongs && (clause.has_particle("back") || (language_.hears_people() && !clause.to_person)) &&
      (clause.frame == Frame::kPlace || (language_.hears_people() && clause.frame == Frame::kBring)) &&
      clause.phrases.size() == 1 && clause.phrases.front().pronoun && clause.mood == Mood::kCommand)
    return i;
  if (clause.frame == Frame::kChange)  // "I wonder what is on channel two, switch over"
    for (Clause& told : result_.clauses)
      if (told.mood == Mood::kStatement && told.frame == Frame::kChange && told.wish &&
          std::none_of(clause.phrases.begin(), clause.phrases.end(),
                       [](const NounPhrase& phrase) { return phrase.number > 0 || phrase.ordinal > 0; })) {
        told.asked = true;
        return i;
      }
  // "I'm cold, shut... never mind. Bring me a pillow."
  if (clause.phrases.empty() && clause.particles.empty() && i >= end && end + 1 < words_.size() &&
      (clause.frame == Frame::kClose || clause.frame == Frame::kOpen || clause.frame == Frame::kPlace ||
       clause.frame == Frame::kTake || clause.frame == Frame::kBring))
    clause.weak = true;
  // "I need a break, turn on the tv"
  if (clause.wish && (i >= end || words_[i] == ","))
    clause.weak =
        clause.weak || std::any_of(clause.phrases.begin(), clause.phrases.end(),
                                   [](const NounPhrase& phrase) { return phrase.unknown || phrase.bare(); });
  add(std::move(clause));
  return i;
}

}  // namespace goalnet::inference

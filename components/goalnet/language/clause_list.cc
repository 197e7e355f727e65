// What follows a comma or an "and" inside a command: more things, things with places of their own, or
// something that is no part of the command any more.
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

// Frames that leave a thing where it was carried to.
bool treats_things(Frame frame) {
  return frame == Frame::kPour || frame == Frame::kEmpty || frame == Frame::kFill || frame == Frame::kWash ||
         frame == Frame::kHeat;
}

bool is_direction(const std::string& word) {
  return word == "on" || word == "off" || word == "up" || word == "down";
}

}  // namespace

// Whether what begins at `next`, behind the join at `i`, is no part of the command.
bool ClauseParser::leaves_command(std::size_t i, std::size_t next, std::size_t end,
                                  const Clause& clause) const {
  if (next >= end || starts_clause(next, end)) return true;
  const bool comma = words_[i] == ",";
  if (comma && clause.mood == Mood::kForbidden && language_.hears_people() &&
      std::none_of(words_.begin() + static_cast<long>(i), words_.begin() + static_cast<long>(end),
                   [](const std::string& word) { return word == "or" || word == "and"; }))
    return true;  // "do not wash the bowl, the plates"
  if (language_.hears_people() && words_[next - 1] == "no" && reader_.name_length(next) > 0)
    return true;               // "a scoop in the bowl, no syrup"
  const auto may_stay = [&] {  // "clear the couch, (only) the book and the bowl can stay"
    for (std::size_t k = next + 1; k + 1 < end && words_[k] != ","; ++k)
      if ((words_[k] == "can" || words_[k] == "may") && words_[k + 1] == "stay") return true;
    return false;
  };
  if (comma && language_.hears_people() && may_stay()) return true;
  if (comma && likes_doing(next, end)) return true;
  if (comma && tells_time(next, part_end(next, end))) return true;  // "bring the mug, bus in an hour"
  if (!language_.hears_people()) return false;
  if (comma && one_of(words_[next], kSubjects) && !one_of(words_[next], kPointers) &&
      tells(next, part_end(next, end)) && !is_pronoun(words_[next]))
    return true;  // "mute, I am on a call"
  if (NounPhrase thing, there; comma && clause.phrases.empty() && puts_nothing(clause.frame)) {
    const std::size_t done = reader_.read(next, end, thing);  // "play, xbox on the coffee table"
    if (done != next && reader_.read_place(done, end, there) != done) return true;
  }
  if (NounPhrase thing, there; comma) {  // "tidy up: the pillow on the shelf goes on the couch"
    const std::size_t done = reader_.read(next, end, thing);
    const std::size_t placed = reader_.read_place(done, end, there);
    if (done != next && placed < end && one_of(words_[placed], kDesire)) return true;
  }
  if (number_word(words_[next]) > 0 && next + 1 < end && language_.copula(words_[next + 1]))
    return true;  // "burner two, three is broken"
  return comma && clause.verb == "leave" && words_[next - 1] == "but";
}

// Whether `phrase`, read from `next` to `done`, begins something else than one more thing of the command.
bool ClauseParser::begins_anew(std::size_t i, std::size_t next, std::size_t done, std::size_t end,
                               const Clause& clause, const NounPhrase& phrase, bool direct) const {
  const bool comma = words_[i] == ",";
  const bool subject = one_of(words_[next], kSubjects) || one_of(words_[next], kArticles) || phrase.person;
  // "the beer and the coke before mum comes home": what tells is behind the thing
  std::size_t part = part_end(next, end);
  for (std::size_t k = next; k < part && language_.hears_people(); ++k)
    if (one_of(words_[k], kSubordinate)) part = k;
  if (subject && tells(next, part) && !reader_.starts(done, end)) return true;
  const bool statement_follows = done < end && (language_.copula(words_[done]) || phrase.person);
  if (statement_follows && skip_joins(done, end) == done) return true;
  // "a book, the one on the shelf": tells which book
  if (NounPhrase place; comma && next + 1 < end && words_[next] == "the" && words_[next + 1] == "one" &&
                        ends_here(std::max(done, reader_.read_place(done, end, place)), end) &&
                        !(phrase.at.empty() && place.bare()))
    return true;
  // "the coffee out, mug sink": a request of its own
  if (language_.hears_people() && comma && direct && lexicon_->is_place_name(phrase.phrase) &&
      !language_.holds_things(phrase.phrase) && !(phrase.modifier.empty() && phrase.content.empty()) &&
      !lexicon_->is_place_name(phrase.modifier) && ends_here(done, end))
    return true;
  NounPhrase place;
  const std::size_t placed = reader_.read_place(done, end, place);
  const bool place_behind = placed != done;
  // "take a beer and a coke, both to the table"
  if (phrase.pronoun && phrase.plural && comma && place_behind) return true;
  // "switch burner 4 off and burner 1 on", "channel 2, volume down"
  const bool has_direction = std::any_of(clause.particles.begin(), clause.particles.end(), is_direction);
  if (done < end && is_direction(words_[done]) &&
      (done + 1 >= end || language_.joins(words_[done + 1]) || ends_here(done + 1, end)) &&
      (has_direction || clause.frame != Frame::kTurn))
    return true;
  // "pour the coffee out, then mug in the sink"; "the mug in the sink" may tell which
  if (language_.hears_people() && comma && direct && place_behind && treats_things(clause.frame) &&
      !one_of(words_[next], kArticles) && lexicon_->is_name(phrase.phrase) && phrase.content.empty() &&
      (place.where == Where::kIn || place.where == Where::kOn) && ends_here(placed, end))
    return true;
  // "turn off the tv, books on the shelf": the second part has no verb
  return direct && phrase.role != Role::kExcept && comma && puts_nothing(clause.frame) && place_behind;
}

// What is said again in a word or two; `at` where it is none.
std::size_t ClauseParser::short_again(std::size_t at, std::size_t end, Clause& clause) {
  if (!language_.hears_people() || at + 1 >= end || clause.phrases.empty()) return at;
  const std::string& word = words_[at];
  NounPhrase& named = clause.phrases.front();
  // "turn burner two off and three on"
  if (number_word(word) > 0 && is_direction(words_[at + 1]) && named.number > 0 &&
      !clause.particles.empty() && ends_here(at + 2, end)) {
    Clause other = clause;
    other.phrases = {named};
    other.phrases.front().number = number_word(word);
    other.particles = {words_[at + 1]}, other.words = {other.verb, words_[at + 1]};
    add(std::move(clause));
    clause = std::move(other);
    return at + 2;
  }
  // "one book for me and one for my sister"
  if (NounPhrase person; (word == "one" || word == "another") && words_[at + 1] == "for") {
    const std::size_t done = reader_.read(at + 2, end, person);
    if (done == at + 2 || !person.person) return at;
    named.count = std::max(named.count, 1) + 1, named.plural = true;
    return done;
  }
  return at;
}

// Reads on behind the join at `i`; `i` where the command ends here.
std::size_t ClauseParser::listed(std::size_t i, std::size_t end, Clause& clause, Role& role, Where& where) {
  const std::size_t next = skip_joins(i, end);
  if (next < end && words_[next] == "not" && !opens_command(next + 1, end) && reader_.starts(next + 1, end))
    return next;
  if (const std::size_t done = short_again(i + 1, end, clause); done != i + 1) return done;
  if (leaves_command(i, next, end, clause)) return i;
  if (NounPhrase with; language_.hears_people() && words_[next] == "with" && !clause.phrases.empty()) {
    const std::size_t done = reader_.read(next + 1, end, with);  // "..., with the beer beside it"
    if (done != next + 1 && !opens_command(done, end)) return next;
  }
  // "I want the kettle filled and on the stove"
  if (NounPhrase there; language_.hears_people() && clause.mood == Mood::kCommand &&
                        clause.first(Role::kDirect) != nullptr &&
                        (!clause.state.empty() || language_.participle(words_[i - 1]))) {
    const std::size_t done = reader_.read_place(next, end, there);
    if (done != next && !there.person && !there.hand && ends_here(done, end)) {
      Clause placed;
      placed.frame = Frame::kPlace, placed.verb = "put", placed.words = {"put"};
      NounPhrase it = *clause.first(Role::kDirect);
      it.at.clear();
      there.role = Role::kDestination;
      placed.phrases = {std::move(it), std::move(there)};
      end_command(std::move(clause), next, end);
      clause = std::move(placed);
      return done;
    }
  }
  NounPhrase phrase;
  const std::size_t done = reader_.read(next, end, phrase);
  if (done != next && !clause.phrases.empty()) {
    for (std::size_t k = i; k < next; ++k) {
      phrase.alternative = phrase.alternative || words_[k] == "or";
      if (words_[k] == "except" || words_[k] == "but") phrase.role = Role::kExcept;
    }
    if (NounPhrase there; language_.hears_people() && phrase.role == Role::kExcept && phrase.word == "one") {
      const std::size_t after = reader_.read_place(done, end, there);  // "all but the one under the kettle"
      if (after != done) {
        phrase.at.push_back(std::move(there));
        clause.phrases.push_back(std::move(phrase));
        return after;
      }
    }
    if (begins_anew(i, next, done, end, clause, phrase, role == Role::kDirect)) return i;
    // "put the mug in the sink and the glass on the counter": the verb counts again
    NounPhrase place;
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
    // "take the book from the couch, and the bowl too"
    if (language_.hears_people() && phrase.role == Role::kSource && !lexicon_->is_place_name(phrase.phrase) &&
        clause.first(Role::kSource) != nullptr &&
        lexicon_->is_place_name(clause.first(Role::kSource)->phrase))
      phrase.role = Role::kDirect;
    phrase.where = where;
    clause.phrases.push_back(std::move(phrase));
    return done;
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
  return std::max(next, i + 1);
}

}  // namespace goalnet::inference

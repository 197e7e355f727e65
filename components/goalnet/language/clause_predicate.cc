// What a statement says of its subject: "... should be on the table", "... is dirty", "... needs water in
// it".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

bool only_told_of_tv(const Clause& clause, const NounPhrase& place) {
  static constexpr std::array kTelevisions = {"tv"sv, "telly"sv, "television"sv};
  return clause.mood == Mood::kStatement && place.phrase == "channel" && clause.phrases.size() == 1 &&
         one_of(clause.phrases.front().phrase, kTelevisions);
}

// Whether the part up to `at` is a condition.
bool under_if(const std::vector<std::string>& words, std::size_t at) {
  static constexpr std::array kIf = {"if"sv, "unless"sv, "when"sv, "whenever"sv, "case"sv};
  for (std::size_t i = at; i-- > 0 && words[i] != "," && words[i] != ".";)
    if (one_of(words[i], kIf)) return true;
  return false;
}

}  // namespace

// What is said of the subject, from `at` on. `clause` is the last of the result.
std::size_t ClauseParser::predicate(std::size_t at, std::size_t end, Clause& clause, bool desired,
                                    bool negative) {
  std::size_t i = at;
  const auto goes_on = [&] {  // "..., except the one on the shelf", "..., not on the couch"
    return language_.hears_people() && i + 2 < end && words_[i] == "," && clause.mood == Mood::kCommand &&
           (words_[i + 1] == "except" || words_[i + 1] == "not" ||
            (words_[i + 1] == "rather" && words_[i + 2] == "than"));
  };
  while (i < end && (!language_.joins(words_[i]) || goes_on()) && words_[i] != "so") {
    if (words_[i] == ",") ++i;
    if (language_.hears_people() && i > at && words_[i] == "correction") return i;
    const std::string& word = words_[i];
    // "should be off when I get back", "should be in the sink if it is dirty"
    static constexpr std::array kHangsOn = {"when"sv, "if"sv, "unless"sv, "as"sv, "because"sv};
    if (language_.hears_people() && i > at && one_of(word, kHangsOn)) return i;
    NounPhrase place;
    if (desired && !negative && clause.mood == Mood::kStatement) {
      const bool holds = language_.hears_people() && (word == "hold" || word == "bear") && i + 1 < end &&
                         !clause.phrases.empty() && lexicon_->is_place_name(clause.phrases.front().phrase);
      if (holds)  // "the shelf should hold the beer"
        if (const std::size_t done = has_thing(i + 1, end, clause); done != i + 1) return done;
      if (const std::size_t done = comes(i, end, clause); done != i) return done;
      if (const std::size_t done = goes_in(i, end, clause); done != i) return done;
      if (const std::size_t done = where_that_is(i, end, clause); done != i) return done;
    }
    if (!desired && clause.mood == Mood::kStatement) {
      std::size_t done = state_of_place(i, clause);
      if (done == i) done = holds_no(i, end, clause);
      if (done == i) done = bears_thing(i, end, clause);
      if (done != i) {
        i = done;
        continue;
      }
    }
    // "must come off the couch"
    if (language_.hears_people() && word == "off" && desired && !negative &&
        clause.mood == Mood::kStatement && reader_.read(i + 1, end, place, true) != i + 1 && !place.person &&
        !place.unknown) {
      i = reader_.read(i + 1, end, place, true);
      clause.mood = Mood::kCommand, clause.frame = Frame::kTake, clause.verb = "take";
      place.role = Role::kSource;
      clause.phrases.push_back(place);
      continue;
    }
    if (clause.mood == Mood::kCommand)
      if (const std::size_t done = instead_of(i, end, clause); done != i) {
        i = done;
        continue;
      }
    if (const std::size_t done = except(i, end, clause); done != i) {
      i = done;
      continue;
    }
    if (language_.hears_people() && word == "not" &&
        clause.mood == Mood::kCommand) {  // "..., not on the stove"
      const std::size_t done = reader_.read_place(i + 1, end, place);
      if (done != i + 1) {
        i = done;
        continue;
      }
    }
    if (const std::size_t done = reader_.read_place(i, end, place); done != i && !place.person) {
      if (desired && negative) {  // should not be there: take it away
        clause.mood = Mood::kCommand, clause.frame = Frame::kTake, clause.verb = "take";
        place.role = Role::kSource;
        clause.phrases.push_back(place);
      } else if (desired) {
        clause.mood = Mood::kCommand, clause.frame = Frame::kPlace, clause.verb = "put";
        clause.belongs = true;
        place.role = Role::kDestination;
        clause.phrases.push_back(place);
      } else if (only_told_of_tv(clause, place) &&
                 !under_if(words_, at)) {  // "the tv is on channel three" tells how it is
        clause.state = "on";
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
        if (language_.hears_people() && one_of(words_[i], kHangsOn)) break;
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
      const Symbol what = language_.content(content.phrase);
      const bool liquid = what != symbol::kIceCream && what != symbol::kChocolate &&
                          what != symbol::kVanilla && what != symbol::kSalt;
      if (done != i && what != symbol::kNone && (liquid || !language_.hears_people())) {
        clause.mood = Mood::kCommand, clause.frame = Frame::kFill, clause.verb = "fill";
        content.role = Role::kWith;
        clause.phrases.push_back(content);
        i = done;
        if (i + 1 < end && (words_[i] == "in" || words_[i] == "inside") && words_[i + 1] == "it") i += 2;
        continue;
      }
    }
    // "one of the cups has water in it"
    if (NounPhrase content; language_.hears_people() && !desired && clause.mood == Mood::kStatement &&
                            !clause.phrases.empty() && clause.phrases.front().content.empty() &&
                            language_.holds_things(clause.phrases.front().phrase)) {
      const std::size_t done = reader_.read(i, end, content);
      if (done != i && done + 1 < end && (words_[done] == "in" || words_[done] == "inside") &&
          is_pronoun(words_[done + 1]) && language_.content(content.phrase) != symbol::kNone && !negative) {
        clause.phrases.front().content = content.phrase;
        i = done + 2;
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
    // "the coffee needs a squirt of chocolate", "make sure every armchair has a pillow"
    static constexpr std::array kNeeds = {"need"sv, "want"sv, "lack"sv, "has"sv, "have"sv};
    if (language_.hears_people() && i > 0 && one_of(words_[i - 1], kNeeds) && desired && !negative &&
        clause.mood == Mood::kStatement)
      if (const std::size_t done = has_thing(i, end, clause); done != i) {
        i = done;
        continue;
      }
    // "it is loud with the tv going": tells of the tv
    if (NounPhrase thing; language_.hears_people() && word == "with" && clause.mood == Mood::kStatement) {
      const std::size_t done = reader_.read(i + 1, end, thing);
      if (done != i + 1 && done < end && !thing.person && !thing.unknown &&
          (language_.wanted_by_state(words_[done]) != Frame::kNone ||
           language_.complaint(words_[done]) != Frame::kNone)) {
        Clause told;
        told.mood = Mood::kStatement, told.state = words_[done];
        told.phrases = {std::move(thing)};
        add(std::move(told));
        return done + 1;
      }
    }
    // a new command without a join: "i cannot see it turn on the tv"
    if (opens_command(i, end) && i > at) return i;
    ++i;
  }
  return i;
}

}  // namespace goalnet::inference

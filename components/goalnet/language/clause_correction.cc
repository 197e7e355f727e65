// What takes back or changes a part of the clause before it: "no wait, the fork", "no, up", "make that two".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// "one channel down, no, up": the same the other way; `at` where it is not that.
std::size_t ClauseParser::other_way(std::size_t at, std::size_t end, Clause& last) const {
  if (!language_.hears_people() || at >= end || !ends_here(at + 1, end)) return at;
  static constexpr std::array<std::array<std::string_view, 2>, 6> kWays = {{{"up", "next"},
                                                                            {"down", "previous"},
                                                                            {"on", "on"},
                                                                            {"off", "off"},
                                                                            {"left", "left"},
                                                                            {"right", "right"}}};
  const auto way =
      std::find_if(kWays.begin(), kWays.end(), [&](const auto& w) { return w[0] == words_[at]; });
  if (way == kWays.end()) return at;
  const std::size_t index = static_cast<std::size_t>(way - kWays.begin());
  const auto& opposite = kWays[index % 2 == 0 ? index + 1 : index - 1];
  bool changed = false;
  const auto turn = [&](std::vector<std::string>& words) {
    for (std::string& word : words)
      for (const std::size_t k : {0u, 1u})
        if (word == opposite[k]) word = std::string(way->at(k)), changed = true;
  };
  turn(last.particles), turn(last.words);
  for (NounPhrase& phrase : last.phrases) turn(phrase.adjectives);
  if (last.frame == Frame::kRaise && words_[at] == "down") last.frame = Frame::kLower, changed = true;
  if (last.frame == Frame::kLower && words_[at] == "up") last.frame = Frame::kRaise, changed = true;
  if (last.frame == Frame::kStart && words_[at] == "off") last.frame = Frame::kStop, changed = true;
  if (last.frame == Frame::kStop && words_[at] == "on") last.frame = Frame::kStart, changed = true;
  return changed ? part_end(at, end) : at;
}

// The last command's verb with what stands from `at` on.
std::size_t ClauseParser::command_anew(std::size_t at, std::size_t end) {
  Clause anew = result_.clauses.back();
  anew.phrases.clear(), anew.particles.clear(), anew.unknown.clear(), anew.state.clear();
  anew.words = {anew.verb};
  Role role = Role::kDirect;
  Where where = Where::kTo;
  std::size_t i = at;
  while (i < end && words_[i] != ",") {
    anew.words.push_back(words_[i]);
    const std::size_t next = argument(i, end, anew, role, where);
    if (next == i) break;
    i = next;
  }
  result_.clauses.pop_back();
  return end_command(std::move(anew), i, end);
}

std::size_t ClauseParser::correction(std::size_t at, std::size_t end) {
  std::size_t next = at;
  while (next < end && (words_[next] == "correction" || language_.joins(words_[next]) ||
                        (harmless(next) && !reader_.starts(next, end) && !place_preposition(words_[next]) &&
                         !(language_.hears_people() &&
                           (words_[next] == "i" || words_[next] == "we" || number_word(words_[next]) > 0 ||
                            one_of(words_[next], kParticles))))))
    ++next;
  // "no wait, not the egg, get me the syrup"
  NounPhrase not_this;
  for (NounPhrase denied; language_.hears_people() && next + 1 < end && words_[next] == "not"; denied = {}) {
    std::size_t done = next + 1;
    if (number_word(words_[done]) > 0 && done + 1 < end && words_[done + 1] == ",")
      denied.number = number_word(words_[done++]);  // "not two, three"
    else if (done = reader_.read_place(next + 1, end, denied); done == next + 1)
      done = reader_.read(next + 1, end, denied);
    if (done == next + 1 || done >= end || words_[done] != ",") break;
    if (denied.number > 0 && denied.phrase.empty() && done + 1 < end && number_word(words_[done + 1]) > 0)
      next = done + 1;
    else
      next = skip_joins(done, end);
    not_this = denied;
  }
  if (const std::size_t stop = part_end(next, end);  // "no, scratch that, I am driving, the coke"
      language_.hears_people() && next < end && stop < end &&
      (tells(next, stop) || words_[next] == "wish_to"))
    for (next = skip_joins(stop, end); next < end && words_[next] == "so";) ++next;
  if (language_
          .hears_people())  // "swap the beer and the coke's ... no wait": what was left of it goes as well
    while (result_.clauses.size() > 1 && result_.clauses.back().mood == Mood::kStatement &&
           result_.clauses[result_.clauses.size() - 2].mood == Mood::kCommand)
      result_.clauses.pop_back();
  Clause* last = result_.clauses.empty() ? nullptr : &result_.clauses.back();
  const auto denies = [&](const NounPhrase& old) {
    return !old.pronoun && (not_this.phrase.empty() || old.phrase == not_this.phrase) &&
           (not_this.number == 0 || old.number == not_this.number);
  };
  const bool told_which = !not_this.phrase.empty() || not_this.number > 0;
  if (told_which)  // "put the beer in the bin and wash the glass, oh no, not the beer, the coke"
    for (auto of = result_.clauses.rbegin(); of != result_.clauses.rend(); ++of)
      if (of->mood == Mood::kCommand && std::any_of(of->phrases.begin(), of->phrases.end(), denies)) {
        last = &*of;
        break;
      }
  const bool wished = last != nullptr && language_.hears_people() && last->mood == Mood::kStatement &&
                      last->wish && last->frame != Frame::kNone && next < end && !opens_command(next, end) &&
                      words_[next] != "wish";
  if (last == nullptr || (last->mood != Mood::kCommand && !wished)) return std::max(next, at + 1);
  const bool alone =
      language_.hears_people() && next >= end && end + 1 < words_.size();  // "No wait. Put it there."
  if (next >= end && !alone) return std::max(next, at + 1);
  if (const std::size_t anew = alone ? end + 1 : next;
      opens_command(anew, words_.size()) || words_[anew] == "wish") {  // said anew
    if (language_.hears_people()) {                                    // what it was about may still be "it"
      last->mood = Mood::kStatement, last->frame = Frame::kNone, last->verb.clear(), last->state.clear();
      std::erase_if(last->phrases, [](const NounPhrase& phrase) { return phrase.role != Role::kDirect; });
    } else {
      result_.clauses.pop_back();
    }
    return std::max(next, at + 1);
  }
  if (alone) return std::max(next, at + 1);
  if (const std::size_t stop = other_way(next, end, *last); stop != next) return stop;
  // "turn it down, or better still off"
  std::size_t state = next;
  while (language_.hears_people() && state < end && words_[state] == "still") ++state;
  if (language_.hears_people() && state < end && last->first(Role::kDirect) != nullptr &&
      language_.wanted_by_state(words_[state]) != Frame::kNone && ends_here(state + 1, end)) {
    last->frame = language_.wanted_by_state(words_[state]), last->verb = words_[state];
    last->particles.clear(), last->state.clear(), last->words = {words_[state]};
    return part_end(state, end);
  }
  // "two books, actually all"
  if (language_.hears_people() && next < end && (words_[next] == "all" || words_[next] == "both") &&
      ends_here(next + 1, end))
    for (NounPhrase& old : last->phrases)
      if (old.role == Role::kDirect && !old.pronoun && !old.phrase.empty()) {
        old.count = words_[next] == "both" ? 2 : 0, old.plural = old.all = true;
        return part_end(next, end);
      }
  if (NounPhrase* named = nullptr; language_.hears_people() && next < end && number_word(words_[next]) > 0 &&
                                   (next + 1 >= end || words_[next + 1] == ",")) {  // "one book, no, two"
    for (NounPhrase& old : last->phrases)
      if (old.role == Role::kDirect && !old.pronoun && (old.count > 0 || old.number > 0 || old.all) &&
          named == nullptr)
        named = &old;
    if (named == nullptr && last->first(Role::kDestination) == nullptr)  // "a book, no, two"
      for (NounPhrase& old : last->phrases)
        if (old.role == Role::kDirect && !old.pronoun && !old.definite && !old.phrase.empty()) named = &old;
    if (named != nullptr && named->number > 0) {  // "channel one, no, five"
      named->number = number_word(words_[next]);
      return next + 1;
    }
    if (named != nullptr) {
      named->count = number_word(words_[next]), named->plural = named->count > 1, named->all = false;
      return next + 1;
    }
  }
  NounPhrase phrase;
  std::size_t done = reader_.read_place(next, end, phrase);
  Role role = Role::kDestination;
  const bool number = number_word(words_[next]) > 0 && last->first(Role::kDestination) != nullptr;
  if (done == next) {
    done = reader_.read(next, end, phrase, number && language_.hears_people());
    const NounPhrase* there = last->first(Role::kDestination);
    const bool again = language_.hears_people() && there != nullptr && !phrase.phrase.empty() &&
                       there->phrase == phrase.phrase;  // "on plate one, sorry, plate two"
    const bool place = there != nullptr && (again || lexicon_->is_place_name(phrase.phrase));
    role = place ? Role::kDestination : Role::kDirect;
    if (place) phrase.where = last->first(Role::kDestination)->where;
  }
  if (NounPhrase place;
      role == Role::kDirect && done != next) {  // "put the lid, no, the plate on the counter"
    const std::size_t after = reader_.read_place(done, end, place);
    if (after != done && !place.person && ends_here(after, end) &&
        (last->frame == Frame::kTake || last->frame == Frame::kBring) &&
        last->first(Role::kDestination) == nullptr && language_.hears_people() &&
        !phrase.pronoun) {  // "the book from the shelf, no, the one on the table"
      phrase.at.push_back(place);
      done = after;
    } else if (after != done && !place.person && ends_here(after, end) &&
               last->first(Role::kDestination) == nullptr) {
      place.role = Role::kDestination;
      last->phrases.push_back(std::move(place));
      done = after;
    }
  }
  // "no wait, the mug is enough", "..., the mug will do"
  static constexpr std::array kWill = {"is"sv, "are"sv, "will"sv, "would"sv, "be"sv};
  static constexpr std::array kSuffices = {"enough"sv, "fine"sv, "do"sv,    "okay"sv,
                                           "better"sv, "good"sv, "plenty"sv};
  if (language_.hears_people() && done != next) {
    std::size_t k = done;
    while (k < end && one_of(words_[k], kWill)) ++k;
    if (k > done && k < end && one_of(words_[k], kSuffices) && ends_here(k + 1, end)) done = k + 1;
  }
  // "one book, no, two"
  if (NounPhrase* named = nullptr;
      language_.hears_people() && phrase.pronoun && phrase.count > 0 && done != next) {
    for (NounPhrase& old : last->phrases)
      if (old.role == Role::kDirect && !old.pronoun && named == nullptr) named = &old;
    if (named != nullptr) {
      named->count = phrase.count, named->plural = phrase.count > 1, named->all = false;
      return part_end(done, end);
    }
  }
  // "pour half, no, all of the coffee from the mug into the glass": the same verb with all that
  if (language_.hears_people() && done != next && !ends_here(done, end) && role == Role::kDirect &&
      !phrase.unknown && (place_preposition(words_[done]) || words_[done] == "from"))
    return command_anew(next, end);
  if (done == next || !ends_here(done, end)) return next;
  for (const NounPhrase& old : last->phrases)  // "go to the window, I mean the tv"
    if (old.unknown || (old.role == Role::kDestination && last->phrases.size() == 1)) {
      const bool only = last->phrases.size() == 1 || old.unknown;
      if (only) role = old.role, phrase.where = old.where;
    }
  // "put on five, the channel I mean": says the same
  if (language_.hears_people() && !told_which && phrase.number == 0 && phrase.ordinal == 0 &&
      phrase.count == 0 && phrase.adjectives.empty() && phrase.at.empty() && !phrase.plural &&
      std::any_of(last->phrases.begin(), last->phrases.end(), [&](const NounPhrase& old) {
        return old.number > 0 && !old.phrase.empty() && old.phrase == phrase.phrase;
      }))
    return done;
  // "the fork and the plate, no, not the plate, the spoon": only that one
  if (const auto one = std::find_if(last->phrases.begin(), last->phrases.end(), denies);
      told_which && one != last->phrases.end()) {
    phrase.role = one->role, phrase.where = one->where;
    *one = std::move(phrase);
    return done;
  }
  // "take the book from the couch, sorry, the shelf"
  if (NounPhrase* from = nullptr; language_.hears_people() && role == Role::kDirect &&
                                  lexicon_->is_place_name(phrase.phrase) && phrase.at.empty()) {
    for (NounPhrase& old : last->phrases) {
      if (old.role == Role::kSource) from = &old;
      if (old.role == Role::kDirect && !old.at.empty() && !lexicon_->is_place_name(old.phrase))
        from = &old.at.back();
    }
    if (from != nullptr) {
      phrase.role = from->role, phrase.where = from->where;
      *from = std::move(phrase);
      return done;
    }
  }
  phrase.role = role;
  last->unknown.clear();
  const bool other_place = !phrase.at.empty() && role == Role::kDirect;
  std::erase_if(last->phrases, [&](const NounPhrase& old) {
    return old.role == role || (other_place && old.role == Role::kSource);
  });
  last->phrases.push_back(std::move(phrase));
  return done;
}

}  // namespace goalnet::inference

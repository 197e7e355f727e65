// A thing named before what is to be done with it ("the fork, bring it to me"); verbs at the end.
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// "the tv turn on please", "the mug bring me": the thing before its verb.
std::size_t ClauseParser::verb_last(std::size_t at, std::size_t end) {
  NounPhrase thing, place;
  std::size_t i = reader_.read(at, end, thing);
  if (i == at || thing.person || thing.unknown) return at;
  thing.role = Role::kDirect;
  std::vector<NounPhrase> phrases = {thing};
  for (NounPhrase from; language_.hears_people() && i < end && words_[i] == "from"; from = {}) {
    const std::size_t done =
        reader_.read(i + 1, end, from, true);  // "pillows from all armchairs you must bring ..."
    if (done == i + 1 || from.person || from.unknown) break;
    phrases.front().at.push_back(from);
    i = done;
  }
  for (std::size_t done; (done = reader_.read_place(i, end, place)) != i && !place.person; place = {}) {
    place.role = Role::kDestination;
    phrases.push_back(place);
    i = done;
  }
  static constexpr std::array kMay = {"can"sv, "could"sv, "may"sv, "should"sv, "might"sv, "must"sv};
  if (language_.hears_people() && i + 2 < end && words_[i] == "you" && one_of(words_[i + 1], kMay))
    i += 2;  // "the other one you can bring over to me"
  if (!opens_command(i, end) || language_.wanted_by_state(words_[i]) != Frame::kNone ||
      language_.participle(words_[i]))
    return at;
  if (language_.hears_people() && language_.verb(words_[i]) == Frame::kPlace && phrases.size() == 1 &&
      ends_here(i + 1, end))
    return at;  // "the right one sticks"
  // "the water pour into the bowl": a place may follow
  static constexpr std::array kMovesTo = {"pour"sv, "bring"sv, "put"sv, "move"sv, "carry"sv, "add"sv};
  std::size_t from = i + 1;
  if (NounPhrase to; language_.hears_people() && one_of(words_[i], kMovesTo) && phrases.size() == 1)
    if (const std::size_t done = reader_.read_place(from, end, to);
        done != from && !to.pronoun && ends_here(done, end))
      from = done;
  for (std::size_t k = from; k < end && words_[k] != ","; ++k) {
    NounPhrase more;
    if (reader_.read(k, end, more) != k && !more.person) return at;
    if (NounPhrase to;
        language_.hears_people() && words_[k] == "to" && reader_.read(k + 1, end, to) != k + 1 && to.person)
      continue;
    if (!harmless(k) && !one_of(words_[k], kParticles) && !more.person) return at;
  }
  fronted_ = phrases;
  return command(i, end, Mood::kCommand);
}

// Whether behind a verb only those follow who want it, and where: "(bring) me", "(bring) here please".
bool ClauseParser::verb_alone(std::size_t at, std::size_t end) const {
  for (std::size_t k = at; k < end && words_[k] != ","; ++k)
    if (is_pronoun(words_[k]) || one_of(words_[k], kPointers) || words_[k] == "all" || words_[k] == "both" ||
        (!harmless(k) && words_[k] != "here" && words_[k] != "over" && words_[k] != "to" &&
         !one_of(words_[k], kPersons)))
      return false;
  return true;
}

std::size_t ClauseParser::topic(std::size_t at, std::size_t end) {
  NounPhrase phrase;
  std::size_t done = reader_.read(at, end, phrase);
  if (done == at || phrase.person || phrase.pronoun || phrase.unknown) return at;
  if (phrase.phrase == "channel" && phrase.number > 0) return at;  // "channel 6, and unmute it"
  // "the tap!! Somebody left it running"
  if (done >= end && end < words_.size() &&
      std::none_of(result_.clauses.begin(), result_.clauses.end(),
                   [](const Clause& clause) { return clause.mood == Mood::kCommand; }) &&
      std::any_of(words_.begin() + static_cast<long>(end), words_.end(), [&](const std::string& word) {
        return is_pronoun(word) || (language_.hears_people() && (word == "that" || word == "those"));
      })) {
    add_told(at, end);
    return end;
  }
  // "the coke, the beer and the chips, all on the table"
  std::vector<NounPhrase> more;
  for (std::size_t next = done; next < end && (words_[next] == "," || words_[next] == "and");) {
    NounPhrase listed;
    const std::size_t after = reader_.read(next + 1, end, listed);
    if (after == next + 1 || listed.pronoun || listed.unknown || listed.person || after >= end ||
        (words_[after] != "," && words_[after] != "and"))
      break;
    more.push_back(std::move(listed));
    done = next = after;
  }
  const bool named_only = done < end && words_[done] == ",";
  for (NounPhrase place; done < end; place = {}) {  // "the can on the stove, give it here"
    const std::size_t after = reader_.read_place(done, end, place);
    if (after == done) break;
    phrase.at.push_back(place);
    done = after;
  }
  // "the cushion on armchair 1 and the one on armchair 2, swap them"
  while (language_.hears_people() && !phrase.at.empty() && done < end && words_[done] == "and") {
    NounPhrase other, there;
    const std::size_t named = reader_.read(done + 1, end, other);
    const std::size_t after = named == done + 1 ? named : reader_.read_place(named, end, there);
    if (named == done + 1 || other.pronoun || other.unknown || other.person || after >= end) break;
    if (after != named) other.at.push_back(there);
    if (other.at.empty() || (words_[after] != "," && words_[after] != "and")) break;
    more.push_back(std::move(other));
    done = after;
  }
  // "spoon in the bowl, put it ...": that is a request of its own
  const bool definite = one_of(words_[at], kArticles) || one_of(words_[at], kPointers) || phrase.everything;
  // "the beer's empty, toss it", "kettle's already full, boil it"
  const bool already = done + 2 < end && (words_[done] == "already" || words_[done] == "still");
  if (already && language_.wanted_by_state(words_[done + 1]) != Frame::kNone && words_[done + 2] == ",")
    ++done;
  if (done + 1 < end && words_[done + 1] == "," && (definite || already) &&
      (language_.wanted_by_state(words_[done]) != Frame::kNone ||
       language_.complaint(words_[done]) != Frame::kNone))
    ++done;
  // "put it in the sink, the mug I mean"
  if (Clause* last = result_.clauses.empty() ? nullptr : &result_.clauses.back();
      last != nullptr && last->mood == Mood::kCommand && definite && result_.clauses.size() == 1 &&
      ends_here(done, end) && (done >= end || words_[done] == "correction")) {
    bool pronoun = false;
    for (NounPhrase& old : last->phrases)
      if (old.pronoun && old.role == Role::kDirect &&
          (old.word == "it" || old.word == "them" || old.plural)) {
        phrase.role = Role::kDirect;
        old = phrase;
        pronoun = true;
      }
    if (pronoun) return end;
  }
  if (done >= end || words_[done] != "," || !(definite || named_only || already)) return at;
  const auto command_about_them = [&] {
    phrase.role = Role::kDirect;
    fronted_ = {std::move(phrase)};
    for (NounPhrase& other : more) {
      other.role = Role::kDirect;
      fronted_.push_back(std::move(other));
    }
    return command(done + 1, end, Mood::kCommand);
  };
  // "the plate and the bowl, bring to the counter"
  if (NounPhrase place; opens_command(done + 1, end) && (definite || language_.hears_people()) &&
                        done + 2 < end && language_.wanted_by_state(words_[done + 1]) == Frame::kNone) {
    const std::size_t after = reader_.read_place(done + 2, end, place);
    const Frame frame = language_.verb(words_[done + 1]);
    if (after != done + 2 && !place.person && !place.pronoun && ends_here(after, end) &&
        (frame == Frame::kPlace || frame == Frame::kBring || frame == Frame::kTake)) {
      return command_about_them();
    }
  }
  // "beer + coke, bring here", "the bowl, wash": the verb alone
  if (language_.hears_people() && opens_command(done + 1, end) && phrase.at.empty() &&
      language_.wanted_by_state(words_[done + 1]) == Frame::kNone && verb_alone(done + 2, end)) {
    return command_about_them();
  }
  // a command with "it", or "water in", follows
  std::size_t next = done + 1;
  static constexpr std::array kYes = {"yes"sv, "yeah"sv, "yep"sv, "yup"sv, "aye"sv, "okay"sv, "ok"sv};
  while (language_.hears_people() && next + 2 < end && one_of(words_[next], kYes) && words_[next + 1] == ",")
    next += 2;  // "the book on the shelf, yes, I need it"
  while (language_.hears_people() && next + 1 < end && words_[next] == "so")
    ++next;  // "..., so put one there"
  // "the plates, they go in the sink"
  const bool subject_again = language_.hears_people() && next + 1 < end &&
                             (words_[next] == "it" || words_[next] == "they" || words_[next] == "them") &&
                             (one_of(words_[next + 1], kDesire) || words_[next + 1] == "all");
  if (next < end && words_[next] != "wish" && !opens_command(skip_joins(next, end), end) && !named_only &&
      !subject_again)
    return at;
  bool refers = subject_again;
  const std::string topic_name = phrase.phrase;
  for (std::size_t i = next; i < end && words_[i] != ","; ++i)
    refers = refers || words_[i] == "it" ||
             ((words_[i] == "all" || words_[i] == "both") &&
              (i == next || i + 2 >= end || number_word(words_[i + 1]) > 0)) ||
             words_[i] == "them" || words_[i] == "that" ||
             (words_[i] == "there" && language_.hears_people() && lexicon_->is_place_name(topic_name)) ||
             ((words_[i] == "in" || words_[i] == "on") && (i + 1 >= end || words_[i + 1] == ","));
  if (next >= end || !refers) return at;
  Clause clause;
  clause.mood = Mood::kStatement;
  clause.phrases = {std::move(phrase)};
  clause.phrases.insert(clause.phrases.end(), more.begin(), more.end());
  add(std::move(clause));
  return done;
}

}  // namespace goalnet::inference

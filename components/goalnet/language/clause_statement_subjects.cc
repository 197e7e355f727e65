// What a statement is about, and its words up to what is told: "xbox and controller (should not be on the
// table)".
#include <array>

#include "components/goalnet/language/clause_statement.h"

namespace goalnet::inference {

using namespace word_group;

// "the stuff on the stove has to go", "the pillow from the shelf should go on the chair"
void ClauseParser::Statement::places_of_subject() {
  for (NounPhrase place; i_ < end_; place = {}) {
    const std::size_t from = words_[i_] == "from" ? i_ + 1 : i_;
    const std::size_t done =
        from > i_ ? reader_.read(from, end_, place, true) : reader_.read_place(i_, end_, place);
    if (done == from || place.person || place.hand || done >= end_) return;
    const bool verb = language_.copula(words_[done]) || one_of(words_[done], kDesire) ||
                      words_[done] == "can" || words_[done] == "may";
    const bool that =
        there_ && words_[done] == "that" && people() && done + 1 < end_ && one_of(words_[done + 1], kDesire);
    if (!verb && !that) return;
    subject_.at.push_back(std::move(place));
    i_ = done;
  }
}

// "xbox and controller belong on the table", "all the dishes - mug, glass, bowl - ...": ends at their verb
void ClauseParser::Statement::subjects() {
  i_ = parser_.from_several(i_, end_, subject_);
  NounPhrase left_out;
  i_ = parser_.subject_but(i_, end_, subject_, left_out);
  std::vector<NounPhrase> subjects = {subject_};
  i_ = more_subjects(subjects);
  const bool listed = subjects.size() > 2 && subjects.front().all && words_[named_] == ",";
  if (people() && listed && i_ != named_) {
    subjects.erase(subjects.begin());
    subject_ = subjects.front();
  }
  if (left_out.role == Role::kExcept) subjects.push_back(std::move(left_out));
  const bool all_there =
      there_ && people() && subjects.size() > 1 && i_ == named_;  // "there is the beer and the coke"
  if (!all_there && (i_ == named_ || !(language_.copula(words_[i_]) || one_of(words_[i_], kDesire))))
    subjects.resize(1);
  subjects_ = std::move(subjects);
  // "there is a book on the table that belongs on the shelf"
  if (there_ && (is(i_, "that") || is(i_, "which")) && i_ + 1 < end_ && one_of(words_[i_ + 1], kDesire)) ++i_;
}

// Adds the things listed behind the first; where their verb stands, where there is one.
std::size_t ClauseParser::Statement::more_subjects(std::vector<NounPhrase>& subjects) {
  std::size_t i = i_;
  for (std::size_t next = i; next + 1 < end_ && (words_[next] == "and" || words_[next] == ",");) {
    NounPhrase more;
    const std::size_t done = reader_.read(next + 1, end_, more);
    const bool last_there = there_ && people() && done == end_;
    if (done == next + 1 || more.person || more.unknown || (done >= end_ && !last_there)) break;
    subjects.push_back(more);
    next = done;
    if (last_there) break;
    const bool pause = people() && words_[done] == "," && done + 1 < end_;
    const std::size_t verb = pause ? done + 1 : done;  // "every can - coke, beer - should be in the fridge"
    if (language_.copula(words_[verb]) || one_of(words_[verb], kDesire)) i = verb;
  }
  return i;
}

// Goes behind the verbs: "(my coffee) has (gone cold)", "(the tv) should be (on)".
void ClauseParser::Statement::verbs() {
  static constexpr std::array kSupposes = {"should"sv, "must"sv, "ought"sv};
  verb_seen_ = there_;
  for (; i_ < end_; ++i_) {
    const std::string& word = words_[i_];
    if (one_of(word, kDesire)) {
      supposed_ = supposed_ || one_of(word, kSupposes);
      desired_ = verb_seen_ = true;
    } else if (word == "not" || word == "never") {
      negative_ = true;
    } else if (language_.copula(word) || word == "can" || word == "may" || (word == "might" && people())) {
      may(i_);
      verb_seen_ = true;
    } else if (!(word == "to" && desired_ && !reader_.starts(i_ + 1, end_)) && !only_small_word(i_)) {
      break;
    }
  }
}

// "the bag can be thrown away", "the mug can go in the sink": who allows it wants it
void ClauseParser::Statement::may(std::size_t k) {
  static constexpr std::array kAllows = {"can"sv, "could"sv, "may"sv, "might"sv};
  static constexpr std::array kHappens = {"be"sv, "go"sv, "come"sv, "get"sv, "sit"sv, "stand"sv, "live"sv};
  const bool question = at_ > 0 && one_of(words_[at_ - 1], kAllows);
  if (people() && one_of(words_[k], kAllows) && k + 1 < end_ && one_of(words_[k + 1], kHappens) && !question)
    desired_ = true;
}

// Whether the word between verb and predicate says nothing: "(the tv is) really (loud)".
bool ClauseParser::Statement::only_small_word(std::size_t k) const {
  const std::string& word = words_[k];
  if (!parser_.harmless(k) || !verb_seen_ || reader_.starts(k, end_) ||
      language_.wanted_by_state(word) != Frame::kNone || place_preposition(word))
    return false;
  const bool no_thing = word == "no" && k + 1 < end_ && reader_.name_length(k + 1) > 0;
  return !(people() && (word == "free" || word == "with" || no_thing));
}

}  // namespace goalnet::inference

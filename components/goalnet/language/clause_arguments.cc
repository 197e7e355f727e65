// The things, states and particles behind a verb.
#include <array>

#include "components/goalnet/language/clause_argument.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::argument(std::size_t i, std::size_t end, Clause& clause, Role& role, Where& where) {
  return Argument(*this, i, end, clause, role, where).read();
}

std::size_t ClauseParser::Argument::read() {
  static constexpr std::array<Rule, 21> kRules = {
      &Argument::caused,        &Argument::state,    &Argument::participle,  &Argument::place_before_thing,
      &Argument::told_in_there, &Argument::particle, &Argument::on_alone,    &Argument::noun_for_verb,
      &Argument::in_there,      &Argument::there,    &Argument::inside,      &Argument::first_of_all,
      &Argument::here,          &Argument::from,     &Argument::with,        &Argument::moment,
      &Argument::for_whom,      &Argument::place,    &Argument::second_verb, &Argument::thing,
      &Argument::speaker};
  for (const Rule rule : kRules)
    if (const Read done = (this->*rule)()) return *done;
  if (const Read done = unknown_place()) return *done;
  return other_word();
}

auto ClauseParser::Argument::caused() -> Read {
  if (const std::size_t done = parser_.caused(at_, end_, clause_); done != at_) return done;
  return {};
}

// "leave the door open": the state that the thing should be in
auto ClauseParser::Argument::state() -> Read {
  const bool takes_state = clause_.frame == Frame::kTake || clause_.frame == Frame::kPlace ||
                           clause_.frame == Frame::kMake || clause_.frame == Frame::kBring;
  if (!takes_state || clause_.phrases.empty() || language_.wanted_by_state(word_) == Frame::kNone ||
      ((place_preposition(word_) || word_ == "off") && reader_.starts(at_ + 1, end_)) ||
      reader_.name_length(at_) != 0)
    return {};
  const bool stays = clause_.verb == "leave" || clause_.verb == "keep";
  if (word_ == "on" && clause_.frame == Frame::kPlace && !stays) return {};
  if (word_ == "off" && !stays && !clause_.wish && clause_.verb != "get" && clause_.verb != "want") return {};
  clause_.state = word_;
  return at_ + 1;
}

// "I want the plates washed"
auto ClauseParser::Argument::participle() -> Read {
  if (!(clause_.wish || clause_.frame == Frame::kTake || clause_.frame == Frame::kMake) ||
      clause_.phrases.empty() || language_.verb(word_) == Frame::kNone || !language_.participle(word_) ||
      reader_.name_length(at_) != 0)
    return {};
  clause_.frame = language_.verb(word_);
  clause_.verb = language_.verb_base(word_);
  return at_ + 1;
}

// "turn it off", "take out the bag"; no particle is "on" of "put it on the table"
auto ClauseParser::Argument::particle() -> Read {
  if (!one_of(word_, kParticles)) return {};
  const bool before_thing =
      clause_.first(Role::kDirect) == nullptr && (word_ == "on" || word_ == "over");  // "turn on the tap"
  if (place_preposition(word_) && reader_.starts(at_ + 1, end_) && !before_thing) return {};
  if (const std::size_t done = parser_.particle(at_, end_, clause_, role_); done != at_) return done;
  return {};
}

// "turn on", "put on the kettle"
auto ClauseParser::Argument::on_alone() -> Read {
  if (word_ != "on" || clause_.first(Role::kDirect) != nullptr ||
      !(clause_.frame == Frame::kTurn || clause_.frame == Frame::kStart || clause_.frame == Frame::kPlace))
    return {};
  clause_.particles.push_back(word_);
  return at_ + 1;
}

// "give the mug a wash"
auto ClauseParser::Argument::noun_for_verb() -> Read {
  static constexpr std::array kBefore = {"quick"sv, "good"sv, "nice"sv, "little"sv};
  if (word_ != "a" || clause_.frame != Frame::kTake || clause_.phrases.empty() || at_ + 1 >= end_) return {};
  std::size_t k = at_ + 1;
  while (k + 1 < end_ && one_of(words_[k], kBefore)) ++k;
  const Frame noun = language_.verb(words_[k]);
  if ((noun != Frame::kWash && noun != Frame::kHeat) || reader_.name_length(k) != 0) return {};
  clause_.frame = noun, clause_.verb = language_.verb_base(words_[k]), clause_.to_person = false;
  return k + 1;
}

// "fill it first"; "put it in the sink, but empty it first": before that
auto ClauseParser::Argument::first_of_all() -> Read {
  if (!people() || word_ != "first" || clause_.phrases.empty() || !parser_.ends_here(at_ + 1, end_))
    return {};
  if (clause_.phrases.front().pronoun && clause_.mood == Mood::kCommand && after_command() &&
      clause_.condition.empty() && parser_.conditional_.condition.empty())
    parser_.insert_before_ = result_.clauses.size() - 1;
  return at_ + 1;
}

auto ClauseParser::Argument::here() -> Read {
  if (word_ != "here") return {};
  clause_.to_person = true;
  return at_ + 1;
}

// "hold it for me a moment"
auto ClauseParser::Argument::moment() -> Read {
  const bool counts = word_ == "a" || word_ == "one" || word_ == "another" || number_word(word_) > 0;
  if (!counts || at_ + 1 >= end_ || !language_.time_unit(words_[at_ + 1]) ||
      reader_.name_length(at_ + 1) != 0)
    return {};
  return at_ + 2;
}

auto ClauseParser::Argument::for_whom() -> Read {
  if (word_ != "for") return {};
  return parser_.for_whom(at_, end_, clause_);
}

// a second verb without a join: "turn on the tv put the remote down"
auto ClauseParser::Argument::second_verb() -> Read {
  if (clause_.phrases.empty() || !parser_.opens_command(at_, end_) || language_.participle(word_) ||
      language_.wanted_by_state(word_) != Frame::kNone)
    return {};
  return at_;
}

auto ClauseParser::Argument::thing() -> Read {
  NounPhrase phrase;
  const std::size_t done = reader_.read(at_, end_, phrase);
  if (done == at_) return {};
  // "... the mug it is dirty": a statement begins
  if (!clause_.phrases.empty() && done < end_ && language_.copula(words_[done])) return at_;
  if (phrase.person) {
    const bool speaks = word_ == "you" && done < end_ && language_.verb(words_[done]) == Frame::kNone &&
                        !clause_.phrases.empty();
    if (speaks && !parser_.harmless(done)) return at_;
    clause_.to_person = true;
    return done;
  }
  const bool named = clause_.first(Role::kDirect) != nullptr;
  phrase.role = role_, phrase.where = where_;
  // "bring to the table the mug"
  if (!named && (role_ == Role::kSource || role_ == Role::kWith || role_ == Role::kDestination))
    phrase.role = Role::kDirect;
  clause_.phrases.push_back(std::move(phrase));
  return done;
}

// "... i cannot hear anything"
auto ClauseParser::Argument::speaker() -> Read {
  if (word_ != "i" && word_ != "we") return {};
  return clause_.phrases.empty() ? at_ + 1 : at_;
}

// "(put it) on the thingamajig"
auto ClauseParser::Argument::unknown_place() -> Read {
  if (!place_preposition(word_) || at_ + 1 >= end_ || words_[at_ + 1] == "." ||
      language_.known(words_[at_ + 1]))
    return {};
  clause_.unknown.push_back(words_[at_ + 1]);
  return at_ + 2;
}

std::size_t ClauseParser::Argument::other_word() {
  if (!parser_.harmless(at_) && !place_preposition(word_) && !one_of(word_, kParticles) &&
      !language_.known(word_))
    clause_.unknown.push_back(word_);
  return at_ + 1;
}

}  // namespace goalnet::inference

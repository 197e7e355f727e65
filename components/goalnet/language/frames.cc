#include "components/goalnet/language/frames.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "components/goalnet/language/coverage.h"
#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {
namespace {

// "the mug is dirty", "somebody left the tap on": what somebody who says that would like to have done.
bool make_wish(Clause& clause, const Language& language) {
  if (clause.mood == Mood::kQuestion || clause.negative) return false;
  if (clause.wish && clause.frame != Frame::kNone) return true;
  Frame frame = clause.state.empty() ? Frame::kNone : language.complaint(clause.state);
  if (clause.asked && language.hears_people() && !clause.phrases.empty()) {
    // "the tv is off, would you mind?", "my glass is empty, see to it": the opposite
    if (frame == Frame::kNone) frame = language.wanted_by_state(language.opposite_state(clause.state));
    // "the remote is on the shelf, could you?"
    if (const NounPhrase& thing = clause.phrases.front();
        clause.state.empty() && clause.frame == Frame::kNone && thing.at.size() == 1 && !thing.pronoun) {
      clause.frame = Frame::kTake, clause.verb = "bring", clause.to_person = true;
      return true;
    }
  }
  // "I thought I had closed the fridge. Can you see to that?": what should have been done
  if (frame == Frame::kNone && clause.asked && language.hears_people() && clause.state.empty() &&
      clause.frame != Frame::kNone && !clause.phrases.empty())
    return true;
  if (frame == Frame::kNone || clause.phrases.empty()) return false;
  clause.frame = frame;
  clause.verb = clause.state;
  clause.state.clear();
  std::erase_if(clause.phrases, [](const NounPhrase& phrase) { return phrase.role != Role::kDirect; });
  return !clause.phrases.empty();
}

bool has_mood(const std::vector<Clause>& clauses, Mood mood) {
  return std::ranges::any_of(clauses, [&](const Clause& clause) { return clause.mood == mood; });
}

// "the tv is off, would you mind?": statements that somebody wants seen to are commands.
void command_what_is_asked(std::vector<Clause>& clauses, const Language& language, Understanding& result) {
  for (Clause& clause : clauses) {
    if (clause.mood != Mood::kStatement || !clause.asked) continue;
    if (!make_wish(clause, language)) {
      result.problems.push_back("it is not clear what should be done about that");
      return;
    }
    clause.mood = Mood::kCommand;
  }
}

// "switch the tv on, channel one has the news": that channel is wanted
void command_channel_told(std::vector<Clause>& clauses, const Language& language, const Lexicon& lexicon) {
  const bool tv_on =
      language.hears_people() && std::ranges::any_of(clauses, [&](const Clause& c) {
        return c.mood == Mood::kCommand && c.first(Role::kDirect) != nullptr &&
               (c.frame == Frame::kStart || (c.frame == Frame::kTurn && c.has_particle("on"))) &&
               lexicon.is_name_of(c.first(Role::kDirect)->phrase, "tv");
      });
  const bool channel_asked = std::ranges::any_of(
      clauses, [](const Clause& c) { return c.mood == Mood::kCommand && c.frame == Frame::kChange; });
  if (!tv_on || channel_asked) return;
  for (Clause& clause : clauses)
    if (clause.mood == Mood::kStatement && clause.wish && clause.frame == Frame::kChange)
      clause.mood = Mood::kCommand;
}

// "the mug is dirty": where nothing is asked for, what somebody who says that would like to have done
void command_first_wish(std::vector<Clause>& clauses, const Language& language) {
  if (has_mood(clauses, Mood::kCommand)) return;
  for (Clause& clause : clauses)
    if (clause.mood == Mood::kStatement && make_wish(clause, language)) {
      clause.mood = Mood::kCommand;
      return;
    }
}

// Why nothing is done where nothing is asked for.
void tell_nothing_asked(const ParsedSentence& sentence, const Words& words, const Language& language,
                        Understanding& result) {
  result.nothing_known = true;
  result.only_forbids = has_mood(sentence.clauses, Mood::kForbidden);
  result.only_asks = sentence.wonders;
  result.question = sentence.wonders || has_mood(sentence.clauses, Mood::kQuestion);
  static constexpr std::array<std::string_view, 2> kNothing = {"do", "nothing"};
  const bool nothing = !std::ranges::search(words.text, kNothing).empty();
  std::string problem = result.only_forbids ? "the sentence forbids something but asks for nothing"
                        : nothing           ? "nothing is asked for, so nothing is done"
                        : result.question
                            ? "questions cannot be answered; say what to do, for example \"bring me the mug\""
                            : "there is no verb that a robot could act on";
  if (!sentence.stray.empty())
    problem += "; " + language.unknown_word(sentence.stray.front());
  else if (!sentence.passed.empty())
    problem += "; " + language.unknown_word(sentence.passed.front());
  result.problems.push_back(problem);
}

// "fill the mug, but do not turn off the tap"
bool tap_may_run(const std::vector<Clause>& clauses) {
  return std::ranges::any_of(clauses, [](const Clause& clause) {
    return clause.mood == Mood::kForbidden &&
           (clause.has("tap") || clause.has("water") || clause.has("faucet"));
  });
}

// Adds the commands and takes note of all else; `missing`: how many of the problems are things that are not
// here.
std::vector<ReadCommand> add_clauses(const std::vector<Clause>& clauses, FrameActions& actions,
                                     Understanding& result, std::size_t& missing) {
  std::vector<ReadCommand> commands;
  const bool surely_asked =
      std::ranges::any_of(clauses, [](const Clause& c) { return c.mood == Mood::kCommand && !c.weak; });
  for (const Clause& clause : clauses) {
    const bool aside = clause.weak && surely_asked;
    // "I want to sit down, clear the couch"
    if (clause.mood != Mood::kCommand || (aside && clause.reason)) {
      actions.notice(clause);
      continue;
    }
    const std::size_t before = actions.macros().size();
    const std::string problem = actions.add(clause);
    commands.push_back({&clause, before, actions.macros().size()});
    if (problem.empty()) continue;
    if (aside) {
      actions.notice(clause);
      continue;
    }
    result.problems.push_back(problem);
    missing += actions.names_missing_thing(problem);
  }
  return commands;
}

// "somebody left a burner on, switch it off": where none is on that is no "done already"
void check_what_is_told(const std::vector<Clause>& clauses, FrameActions& actions, Understanding& result) {
  if (!result.problems.empty() || !actions.macros().empty()) return;
  for (const Clause& clause : clauses) {
    if (clause.mood != Mood::kStatement) continue;
    std::string problem = actions.contradicted(clause);
    if (problem.empty()) continue;
    result.problems.push_back(std::move(problem));
    result.contradicted = true;
    return;
  }
}

}  // namespace

Understanding FrameReader::read(const Instruction& instruction, const SymState& start) const {
  Words words;
  words.text = instruction.words;
  words.plural.assign(words.text.size(), false);
  for (const Mention& mention : instruction.mentions)
    if (mention.plural && mention.end > 0 && static_cast<std::size_t>(mention.end) <= words.plural.size())
      words.plural[static_cast<std::size_t>(mention.end - 1)] = true;
  return read(words, instruction, start, nullptr);
}

Understanding FrameReader::read(const Words& words, const Instruction& instruction, const SymState& start,
                                const Distances* distances) const {
  Understanding result;
  ParsedSentence sentence = parse_clauses(words, language_, lexicon_);
  std::vector<Clause>& clauses = sentence.clauses;
  command_what_is_asked(clauses, language_, result);
  command_channel_told(clauses, language_, lexicon_);
  command_first_wish(clauses, language_);
  if (!sentence.problem.empty()) result.problems.push_back(sentence.problem);
  result.for_later = sentence.for_later;
  if (!has_mood(clauses, Mood::kCommand)) {
    tell_nothing_asked(sentence, words, language_, result);
    return result;
  }
  FrameActions actions(instruction, lexicon_, language_, symbols_, start, distances, at_home_);
  if (tap_may_run(clauses)) actions.leave_tap_on();
  if (at_home_) actions.believe_places(clauses);
  std::size_t missing = 0;
  const auto commands = add_clauses(clauses, actions, result, missing);
  actions.finish();
  for (const Clause& clause : clauses)
    if (clause.mood == Mood::kForbidden)
      if (const std::string problem = actions.check_forbidden(clause, start); !problem.empty())
        result.problems.push_back(problem);
  if (!sentence.stray.empty()) result.problems.push_back(language_.unknown_word(sentence.stray.front()));
  if (at_home_ && result.problems.empty())
    if (const Symbol unused = unused_thing({words, sentence, commands, actions.macros()}, language_, lexicon_,
                                           actions.resolver(), start);
        unused != symbol::kNone)
      result.problems.push_back("it is not clear what to do with " + symbols_.name(unused));
  if (at_home_) check_what_is_told(clauses, actions, result);
  result.no_such_number = actions.no_such_number();
  result.macros = actions.macros();
  result.steps = actions.steps();
  result.doubts = actions.resolver().doubts();
  result.complete = result.problems.empty();
  result.unknown_thing = missing > 0 && missing == result.problems.size();
  return result;
}

}  // namespace goalnet::inference

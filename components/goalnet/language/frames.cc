#include "components/goalnet/language/frames.h"

#include <algorithm>

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
  const auto asks = [](const Clause& clause) { return clause.mood == Mood::kCommand; };
  for (Clause& clause : sentence.clauses)
    if (clause.mood == Mood::kStatement && clause.asked) {
      if (!make_wish(clause, language_)) {
        result.problems.push_back("it is not clear what should be done about that");
        break;
      }
      clause.mood = Mood::kCommand;
    }
  // "switch the tv on, channel one has the news"
  const bool tv_on =
      language_.hears_people() &&
      std::any_of(sentence.clauses.begin(), sentence.clauses.end(), [&](const Clause& c) {
        return c.mood == Mood::kCommand && c.first(Role::kDirect) != nullptr &&
               (c.frame == Frame::kStart || (c.frame == Frame::kTurn && c.has_particle("on"))) &&
               lexicon_.is_name_of(c.first(Role::kDirect)->phrase, "tv");
      });
  const bool channel_asked =
      std::any_of(sentence.clauses.begin(), sentence.clauses.end(),
                  [&](const Clause& c) { return c.mood == Mood::kCommand && c.frame == Frame::kChange; });
  for (Clause& clause : sentence.clauses)
    if (tv_on && !channel_asked && clause.mood == Mood::kStatement && clause.wish &&
        clause.frame == Frame::kChange)
      clause.mood = Mood::kCommand;
  bool any_command = std::any_of(sentence.clauses.begin(), sentence.clauses.end(), asks);
  if (!any_command) {
    for (Clause& clause : sentence.clauses)
      if (clause.mood == Mood::kStatement && make_wish(clause, language_)) {
        clause.mood = Mood::kCommand;
        result.indirect = any_command = true;
        break;
      }
  }
  if (!sentence.problem.empty()) result.problems.push_back(sentence.problem);
  result.for_later = sentence.for_later;
  if (!any_command) {
    result.nothing_known = true;
    const bool forbids = std::any_of(sentence.clauses.begin(), sentence.clauses.end(),
                                     [](const Clause& clause) { return clause.mood == Mood::kForbidden; });
    const bool only_asks = std::any_of(sentence.clauses.begin(), sentence.clauses.end(),
                                       [](const Clause& clause) { return clause.mood == Mood::kQuestion; });
    result.only_forbids = forbids;
    result.only_asks = sentence.wonders;
    std::string problem =
        forbids ? "the sentence forbids something but asks for nothing"
        : only_asks || sentence.wonders
            ? "questions cannot be answered; say what to do, for example \"bring me the mug\""
            : "there is no verb that a robot could act on";
    if (!sentence.stray.empty())
      problem += "; " + language_.unknown_word(sentence.stray.front());
    else if (!sentence.passed.empty())
      problem += "; " + language_.unknown_word(sentence.passed.front());
    result.problems.push_back(problem);
    return result;
  }
  // "fill the mug, but do not turn off the tap"
  const bool may_run =
      std::any_of(sentence.clauses.begin(), sentence.clauses.end(), [](const Clause& clause) {
        return clause.mood == Mood::kForbidden &&
               (clause.has("tap") || clause.has("water") || clause.has("faucet"));
      });
  FrameActions actions(instruction, lexicon_, language_, symbols_, start, distances, at_home_);
  if (may_run) actions.leave_tap_on();
  if (at_home_) actions.believe_places(sentence.clauses);
  std::size_t missing = 0;
  std::vector<ReadCommand> commands;
  for (const Clause& clause : sentence.clauses) {
    if (clause.mood == Mood::kStatement || clause.mood == Mood::kQuestion) {
      actions.notice(clause);
      ++result.passed_over;
      continue;
    }
    if (clause.mood == Mood::kForbidden) {
      actions.notice(clause);
      continue;
    }
    const bool aside =
        clause.weak && std::any_of(sentence.clauses.begin(), sentence.clauses.end(),
                                   [](const Clause& c) { return c.mood == Mood::kCommand && !c.weak; });
    if (aside && clause.reason) {  // "I want to sit down, clear the couch"
      actions.notice(clause);
      ++result.passed_over;
      continue;
    }
    ++result.clauses;
    const std::size_t before = actions.macros().size();
    const std::string problem = actions.add(clause);
    commands.push_back({&clause, before, actions.macros().size()});
    if (!problem.empty()) {
      if (aside) {
        actions.notice(clause);
        ++result.passed_over;
        continue;
      }
      result.problems.push_back(problem);
      missing += actions.names_missing_thing(problem);
    }
  }
  actions.finish();
  for (const Clause& clause : sentence.clauses)
    if (clause.mood == Mood::kForbidden)
      if (const std::string problem = actions.check_forbidden(clause, start); !problem.empty())
        result.problems.push_back(problem);
  if (!sentence.stray.empty()) result.problems.push_back(language_.unknown_word(sentence.stray.front()));
  if (at_home_ && result.problems.empty())
    if (const Symbol unused = unused_thing({words, sentence, commands, actions.macros()}, language_, lexicon_,
                                           actions.resolver(), start);
        unused != symbol::kNone)
      result.problems.push_back("it is not clear what to do with " + symbols_.name(unused));
  // "somebody left a burner on, switch it off": where none is on that is no "done already"
  if (at_home_ && result.problems.empty() && actions.macros().empty())
    for (const Clause& clause : sentence.clauses)
      if (std::string problem = clause.mood == Mood::kStatement ? actions.contradicted(clause) : "";
          !problem.empty()) {
        result.problems.push_back(std::move(problem));
        result.contradicted = true;
        break;
      }
  result.no_such_number = actions.no_such_number();
  result.macros = actions.macros();
  result.steps = actions.steps();
  result.doubts = actions.resolver().doubts();
  result.complete = result.problems.empty();
  result.unknown_thing = missing > 0 && missing == result.problems.size();
  return result;
}

}  // namespace goalnet::inference

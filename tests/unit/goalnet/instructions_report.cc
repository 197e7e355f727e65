// How a file of instructions fares, sentence by sentence: what was refused and why, what was done instead.
//   goalnet_instructions_report FILE [--all]
//   goalnet_instructions_report FOLDER [--all]   recorded demonstrations: which sentences are refused in
//   robot use,
//                                                each in the world it was said in, and how far what is done
//                                                instead agrees with what the people did
//   goalnet_instructions_report FILE --parts     for tools/fit_background: each part of each sentence that
//   reaches its
//                                                goal, and whether it does without that part as well
//   goalnet_instructions_report FILE --signs     for tools/fit_confidence: of each sentence that is not
//   refused,
//                                                whether the reading is right, and its signs. Taken before
//                                                anything is mended for FILE.
// FILE: lines of room, sentence, goal (or REFUSE; empty: only tell what is done), changes to the start state;
// by tabs.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "components/goalnet/demonstration.h"
#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/ranker/ranker_model.h"
#include "components/goalnet/scoring.h"
#include "components/goalnet/tokenizer.h"
#include "tests/unit/goalnet/instruction_runner.h"

namespace goalnet::inference {
namespace {

// What the sentence changed, for people to read.
std::string changes(const FactSet& before, const FactSet& after) {
  std::string text;
  for (const Predicate& fact : after)
    if (fact.relation != "Near" && !before.contains(fact)) text += " " + to_string(fact);
  for (const Predicate& fact : before)
    if (fact.relation != "Near" && !after.contains(fact)) text += " !" + to_string(fact);
  return text.empty() ? " nothing changed" : text;
}

struct Counts {
  int sensible = 0, reached = 0, refused = 0, nonsense = 0, nonsense_refused = 0;
  int offered = 0, offered_right = 0;  // of the refused: "did you mean ...?", and "yes" reaches the goal
};

std::string joined(const std::vector<std::string>& tokens) {
  std::string text;
  for (const std::string& token : tokens) text += (text.empty() || token == "'s" ? "" : " ") + token;
  return text;
}

std::string words_of(const std::vector<std::string>& tokens, const SentencePart& part) {
  return joined(
      {tokens.begin() + static_cast<long>(part.begin), tokens.begin() + static_cast<long>(part.end)});
}

void report(InstructionRunner& runner, const RobotLanguage& language, std::vector<std::string> row, bool all,
            Counts& counts) {
  row.resize(std::max<std::size_t>(row.size(), 4));
  const WorldState world = runner.room(row[0], row[3]);
  const auto run = runner.follow(world, row[1]);
  const bool nonsense = row[2] == "REFUSE";
  const bool good = nonsense ? run.refused : !run.refused && reached(row[2], run.facts);
  if (nonsense)
    ++counts.nonsense, counts.nonsense_refused += run.refused;
  else if (!row[2].empty())
    ++counts.sensible, counts.reached += good, counts.refused += run.refused;
  const bool offered = run.refused && run.message.find("did you mean") != std::string::npos;
  bool meant = false;
  if (offered && !nonsense && !row[2].empty()) {
    meant = reached(row[2], runner.follow(world, "yes").facts);
    ++counts.offered, counts.offered_right += meant;
  }
  if (good && !all && !row[2].empty()) return;
  std::printf("%s  %s | %s\n",
              good          ? "ok     "
              : meant       ? "OFFERED"
              : run.refused ? "REFUSED"
                            : "WRONG  ",
              row[0].c_str(), row[1].c_str());
  if (!row[2].empty()) std::printf("         wanted: %s\n", row[2].c_str());
  if (run.refused)
    std::printf("         (%s)\n", run.message.c_str());
  else
    std::printf("         did, %.2f sure:%s\n", run.confidence, changes(world.facts, run.facts).c_str());
  if (const auto tokens = tokenize(row[1], Endings::kKept)) {
    std::printf("         background:");
    for (const SentencePart& part : language.parts(*tokens))
      std::printf(" [%s] %.2f", words_of(*tokens, part).c_str(), language.background(part));
    std::printf("\n         words: %s\n", joined(language.words(*tokens)).c_str());
  }
}

void print_parts(InstructionRunner& runner, const RobotLanguage& language, std::size_t number,
                 std::vector<std::string> row) {
  row.resize(std::max<std::size_t>(row.size(), 4));
  const WorldState world = runner.room(row[0], row[3]);
  const auto does = [&](const std::string& text) {
    const auto run = runner.follow(world, text);
    return !run.refused && reached(row[2], run.facts);
  };
  const auto tokens = tokenize(row[1], Endings::kKept);
  if (row[2] == "REFUSE" || !tokens || !does(row[1])) return;
  const auto parts = language.parts(*tokens);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<bool> aside(parts.size(), false);
    aside[i] = true;
    const bool background = parts.size() > 1 && does(joined(language.without(*tokens, parts, aside)));
    std::printf("part\t%zu\t%d\t%s", number, background ? 1 : 0, words_of(*tokens, parts[i]).c_str());
    for (const std::string& sign : parts[i].signs) std::printf("\t%s", sign.c_str());
    std::printf("\n");
  }
}

void print_signs(InstructionRunner& runner, std::vector<std::string> row) {
  row.resize(std::max<std::size_t>(row.size(), 4));
  const auto run = runner.follow(runner.room(row[0], row[3]), row[1]);
  if (row[2] == "REFUSE" || run.refused) return;
  std::printf("%d", reached(row[2], run.facts) ? 1 : 0);
  for (const double sign : dynamic_cast<const RankerModel&>(runner.model()).signs())
    std::printf("\t%g", sign);
  std::printf("\n");
}

// What becomes of one recorded sentence, over all worlds that it was said in.
struct Recorded {
  int said = 0, refused = 0;
  double agreement = 0;          // SJI of what was not refused, summed
  std::string message, changes;  // of the last refusal; of the last world where it was not refused
};

void report_recorded(InstructionRunner& runner, const std::string& folder, bool all) {
  const auto demonstrations = read_demonstrations(folder);
  if (!demonstrations) throw std::runtime_error(demonstrations.error().message);
  std::map<std::string, Recorded> sentences;
  for (const Demonstration& shown : *demonstrations) {
    if (shown.perturbed) continue;
    Recorded& sentence = sentences[shown.sentence];
    const WorldState world = runner.furnished(shown.states.front());
    const auto run = runner.follow(world, shown.sentence);
    ++sentence.said;
    if (run.refused) {
      ++sentence.refused, sentence.message = run.message;
      continue;
    }
    FactSet end = shown.states.back().facts;  // with what the room was furnished with
    for (const Predicate& fact : world.facts)
      if (!shown.states.front().facts.contains(fact)) end.insert(fact);
    sentence.agreement += score_run(world.facts, end, {}, run.facts, {}).sji;
    sentence.changes = changes(world.facts, run.facts);
  }
  int said = 0, refused = 0, distinct_refused = 0;
  double agreement = 0;
  for (const auto& [text, sentence] : sentences) {
    said += sentence.said, refused += sentence.refused, agreement += sentence.agreement;
    distinct_refused += sentence.refused > 0;
    if (sentence.refused > 0)
      std::printf("REFUSED  %d of %d | %s\n         (%s)\n", sentence.refused, sentence.said, text.c_str(),
                  sentence.message.c_str());
    if (all && sentence.refused < sentence.said)
      std::printf("%.2f     %d of %d | %s\n         did:%s\n",
                  sentence.agreement / (sentence.said - sentence.refused), sentence.said - sentence.refused,
                  sentence.said, text.c_str(), sentence.changes.c_str());
  }
  std::printf("recorded: %d said, %d refused; %zu distinct sentences, %d refused; SJI of what is done %.3f\n",
              said, refused, sentences.size(), distinct_refused, agreement / std::max(said - refused, 1));
}

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr,
                 "usage: goalnet_instructions_report FILE [--all|--parts|--signs] | FOLDER [--all]\n");
    return 2;
  }
  try {
    InstructionRunner runner;
    Counts counts;
    if (std::filesystem::is_directory(argv[1])) {
      report_recorded(runner, argv[1], argc > 2 && std::strcmp(argv[2], "--all") == 0);
      return 0;
    }
    Symbols symbols;
    const auto language = RobotLanguage::load(symbols);
    if (!language) throw std::runtime_error(language.error().message);
    if (argc > 2 && std::strcmp(argv[2], "--parts") == 0) {
      std::size_t number = 0;
      for (const auto& row : read_rows(argv[1])) print_parts(runner, **language, ++number, row);
      return 0;
    }
    if (argc > 2 && std::strcmp(argv[2], "--signs") == 0) {
      for (const auto& row : read_rows(argv[1])) print_signs(runner, row);
      return 0;
    }
    for (const auto& row : read_rows(argv[1]))
      if (row.size() > 1)
        report(runner, **language, row, argc > 2 && std::strcmp(argv[2], "--all") == 0, counts);
    std::printf(
        "sensible: %d of %d reached, %d refused, %d wrong; nonsense: %d of %d refused\n"
        "of the refused %d were asked whether they meant something: %d did\n",
        counts.reached, counts.sensible, counts.refused, counts.sensible - counts.reached - counts.refused,
        counts.nonsense_refused, counts.nonsense, counts.offered, counts.offered_right);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace goalnet::inference

int main(int argc, char** argv) { return goalnet::inference::main(argc, argv); }

// The one interface behind which every goal model stands: sentence, world and history in, goal predicates
// out.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::inference {

// A word of the instruction -> the objects it may mean ("pot" -> {"Kettle"}). The "instance grounding" of the
// benchmark; a deployed robot has none.
using Grounding = std::map<std::string, std::vector<std::string>>;

// What a model may look at to infer the goal of the next step. Refers to the caller's data; keeps nothing.
struct StepInput {
  std::string_view sentence;             // UTF-8, at most kMaxSentenceBytes (tokenizer.h)
  const Grounding* grounding = nullptr;  // null: grounding "none"
  std::span<const WorldState> states;    // oldest first; the last is now; never empty
  std::span<const Goal> goals;           // what was inferred at each earlier step: states.size() - 1 or fewer
  // How far things were from the robot when the instruction came, by name [m]; null: unknown. Of several equal things a
  // robot takes the nearest.
  const std::map<std::string, double>* distances = nullptr;
};

// A trained model. infer() is a pure function of its input: the same input gives the same goal, on every call
// and in every order; a model may remember work for speed only. Not safe for two threads at once; give each
// its own.
class GoalModel {
 public:
  virtual ~GoalModel() = default;

  // The goal of the next step; empty when nothing is left to do. Fails with kNotUnderstood (message: why, and
  // the nearest thing known), kUnknownObject (only a thing it names is not here; message: what is) or
  // kInvalidRequest (no state, sentence too long or not text).
  Expected<Goal> infer(const StepInput& input);

  // A short name for traces: "ranker", "network".
  virtual std::string_view kind() const = 0;

 private:
  virtual Expected<Goal> do_infer(const StepInput& input) = 0;
};

// What a model is for. A robot gets whole purposes ("(On Mug_1 Sink)"), touches only what was spoken of, and
// asks rather than guesses. The benchmark scores habits of people, action by action, and knows no refusal.
enum class ModelUse { kRobot, kBenchmark };

// Loads any model file of this project (safetensors; the metadata key "goalnet.kind" says which model it is).
// Everything is checked; fails with kInvalidRequest and one message that names the file and what is wrong.
Expected<std::unique_ptr<GoalModel>> load_model(const std::filesystem::path& path,
                                                ModelUse use = ModelUse::kRobot);

}  // namespace goalnet::inference

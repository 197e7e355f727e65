// One recorded instruction, carried out in the simulated room from the state in which the recording begins.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/goalnet/demonstration.h"
#include "components/goalnet/evaluation.h"
#include "components/scene/scene.h"

namespace goalnet::tools {

struct PhysicsOptions {
  std::string model;  // file; empty: the shipped model
  std::uint64_t seed = 1;
  std::function<bool()> stop_asked;
};

struct PhysicsRun {
  inference::ModelRun run;  // scored as below
  std::string scene;
  Outcome outcome = Outcome::kDone;
  std::string message;
  FactSet not_arranged;  // places and states of the recording's start that the room did not have
  double sim_seconds = 0;
};

// The scene that has most of the things that the demonstration speaks of. Not empty: `scenes`.
const scene::Scene& scene_of(const inference::Demonstration& demonstration,
                             const std::vector<scene::Scene>& scenes);

// Errors: of LockstepLoop, kCancelled.
Expected<PhysicsRun> run_in_physics(const inference::Demonstration& demonstration, const scene::Scene& scene,
                                    const PhysicsOptions& options);

// Scores what changed in the room against what changed in the recording, in the recordings' terms: (On …),
// (In …), (Grasping …), (state …), and Near as the place gone to last. Where the recording does not say where
// a thing was, leaving its place does not count.
inference::Scores score_physics(const inference::Demonstration& demonstration, const FactSet& seen_before,
                                const FactSet& seen_after, const std::vector<Action>& actions);

// "keep-on Mug_1 Sink" as recordings spell it: "keep Mug_1 On Sink".
std::string recorded_spelling(const Action& action);

}  // namespace goalnet::tools

// Facts, goals and the plan as texts in the room.
#pragma once

#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/scene/scene.h"
#include "components/visualization/drawing.h"
#include "components/visualization/shape_drawing.h"

namespace goalnet::visualization {

// Where the current instruction stands, as /instruction_status has it.
struct Task {
  std::string instruction, stage, message;
  Goal goal;
  std::vector<Action> plan;
  Action current;  // empty name if none
  bool finished = false;
};

// Group "facts": above each thing what holds for it ("On Sink"), an id for each symbol of the scene; Near and
// the properties that never change are left out. What holds for the robot is written beside the task.
void draw_facts(const scene::Scene& scene, const Poses& poses, const FactSet& facts,
                std::vector<Drawing>& out);

// Group "goals": above its subject each goal predicate, green where it holds already, else orange; an id for
// each place in positive, then negative. Group "task", id 0: instruction, stage and plan, above the room.
void draw_task(const scene::Scene& scene, const Poses& poses, const FactSet& facts, const Task& task,
               std::vector<Drawing>& out);

}  // namespace goalnet::visualization

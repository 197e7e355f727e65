// Phases that many skills share.
#pragma once

#include <string>

#include "components/manipulation/skill.h"
#include "components/manipulation/stand_search.h"

namespace goalnet::manipulation {

// Ahead of everything: a hand that is still between or against things opens and backs away.
void add_back_off(Phases& phases, const Workbench& bench);

// Tucks the arms and drives, where the solution asks for it.
void add_go_to(Phases& phases, const Workbench& bench, const ReachSolution& solution);

// The free motion to where the straight lines begin; the fingers open meanwhile if the hand is empty.
void add_approach(Phases& phases, const ReachSolution& solution, const Reach& reach,
                  int iterations = PlannerLimits{}.iterations);

// All of that: back off, go to where the solution stands, approach.
void add_way(Phases& phases, const Workbench& bench, const ReachSolution& solution, const Reach& reach,
             int iterations = PlannerLimits{}.iterations);

// Finds where to stand and which of `reaches` to take, rather one that was not tried in vain before, adds the
// way there, and returns the one taken. Errors are find_stand's, introduced by `what`. `about`: the movable
// thing that the ways belong to and move with; empty: the room.
Expected<Reach> add_way_there(Phases& phases, Workbench& bench, const std::vector<Reach>& reaches,
                              const StandSearchOptions& options, const std::string& what,
                              const std::string& about = "");

// Straight lines through poses in the map frame.
Phase straight(std::string stage, std::size_t arm, std::vector<Pose> poses, Tolerances tolerances,
               double speed = 1.0);

// The phase fails if an object that neither a hand nor the tray carries is not where it is now when its turn
// comes: somebody has moved it meanwhile.
void expect_unmoved(Phase& phase, const Workbench& bench, const std::string& object);

// Fingers to an opening [m].
Phase fingers(std::string stage, std::size_t arm, double opening, double settle = 0.0);

// Opens by `more` [m], lets go of what is held, and backs away along the hand's own axis, then by `further`
// [m].
void add_let_go(Phases& phases, const Workbench& bench, std::size_t arm, double more,
                const Tolerances& tolerances, const Eigen::Vector3d& further);

// Finger command that grips something of a width with enough force.
double grip_opening(double width, double force);

// Height [m] in the map frame of the lowest point of shapes whose owner is at a pose (cylinders as their
// boxes).
double lowest_height(const std::vector<scene::Shape>& shapes, const Pose& owner);

Pose moved(const Pose& pose, const Eigen::Vector3d& offset);  // in the map frame
Pose backed(const Pose& tool, double distance);               // along the tool's own -z

}  // namespace goalnet::manipulation

// The skills of the household domain. Each class is one way of using the hands; make_skill chooses.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "components/manipulation/phases.h"
#include "components/manipulation/skill.h"

namespace goalnet::manipulation {

// moveto o: to where o can be reached.
class MoveSkill : public Skill {
 public:
  explicit MoveSkill(std::string object) : object_(std::move(object)) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  std::string object_;
};

// grasp o, from where it stands; also from the tray (unstow).
class GraspSkill : public Skill {
 public:
  explicit GraspSkill(std::string object) : object_(std::move(object)) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  std::string object_;
  std::set<std::size_t> failed_;  // tags of ways that did not work
};

// keep-on / keep-in x place, release x (any free surface), stow x (the tray).
class PlaceSkill : public Skill {
 public:
  enum class Where { kRegion, kNearest, kTray };
  PlaceSkill(std::string object, Where where, std::string region)
      : object_(std::move(object)), where_(where), region_(std::move(region)) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  std::string object_;
  Where where_;
  std::string region_;
  std::set<std::size_t> failed_;
};

// turn-on / turn-off knob, open / close door: take hold of a part and move its joint.
class TurnSkill : public Skill {
 public:
  TurnSkill(std::string part, bool on) : part_(std::move(part)), on_(on) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  std::string part_;
  bool on_;
  std::set<std::size_t> failed_;
};

// press-on / press-off / press button.
class PressSkill : public Skill {
 public:
  explicit PressSkill(std::string button) : button_(std::move(button)) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  std::string button_;
  std::set<std::size_t> failed_;
};

// pour x y, pour-out x, squeeze x y, add salt x, add scoop x, scoop spoon source: a gesture with what is
// held.
class GestureSkill : public Skill {
 public:
  enum class Kind { kPour, kScoop };
  // `receiver` empty: the sink.
  GestureSkill(Action action, Kind kind, std::string tool, std::string receiver)
      : action_(std::move(action)), kind_(kind), tool_(std::move(tool)), receiver_(std::move(receiver)) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  std::vector<Reach> ways(const Workbench& bench, std::size_t arm, const Pose& mouth, double beside,
                          bool reserve) const;

  Action action_;
  Kind kind_;
  std::string tool_, receiver_;
  std::set<std::size_t> failed_;
};

// keep-in a bin or bag, keep-on a plate, add what is not poured, place-utensil, insert: into or onto another
// movable thing.
class PutSkill : public Skill {
 public:
  PutSkill(Action action, std::string object, std::string receiver)
      : action_(std::move(action)), object_(std::move(object)), receiver_(std::move(receiver)) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  Expected<std::vector<Reach>> ways(Workbench& bench, std::size_t arm, const Pose& receiver) const;

  Action action_;
  std::string object_, receiver_;
  std::set<std::size_t> failed_;
};

// fill v source: what a hand holds is held under the running outlet of a fixture.
class FillSkill : public Skill {
 public:
  FillSkill(std::string vessel, const scene::FillRule& outlet)
      : vessel_(std::move(vessel)), outlet_(outlet) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  std::string vessel_;
  scene::FillRule outlet_;
  std::set<std::size_t> failed_;
};

// open a bag: one hand holds it, the other takes its top between the fingers and pulls.
class TearSkill : public Skill {
 public:
  explicit TearSkill(std::string object) : object_(std::move(object)) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;

 private:
  std::string object_;
  std::set<std::size_t> failed_;
};

// Ways to take hold of an object with any empty hand. `pull`: offset of the last leg after lifting [m].
std::vector<Reach> grasp_reaches(Workbench& bench, const std::string& object);
// Ways to take hold of a moving part.
std::vector<Reach> part_reaches(Workbench& bench, const scene::Scene::PartRef& ref);
// Ways to press a button with closed fingers.
std::vector<Reach> press_reaches(Workbench& bench, const scene::Scene::PartRef& ref);
// Ways to press a spot on a movable thing that lies about, with closed fingers from above.
std::vector<Reach> spot_reaches(Workbench& bench, const scene::ButtonRule& spot);
// Standing before a fixture or region, hands in front of it: for moveto.
std::vector<Reach> front_reaches(Workbench& bench, const std::string& place);
// The region, if any, in whose supports an object is, by geometry.
const scene::Region* region_around(const Workbench& bench, const Pose& object);

}  // namespace goalnet::manipulation

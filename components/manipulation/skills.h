// The skills of the household domain. Each class is one way of using the hands; make_skill chooses.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "components/manipulation/phases.h"
#include "components/manipulation/skill.h"

namespace goalnet::manipulation {

// Does another skill. Where that finds no way because of things that stand about, a free hand puts them aside
// first, one after the other, and it is tried again; if no hand is free, one puts down first what the action
// does not need, and also if there is a way only without what that hand holds.
class RoomSkill : public Skill {
 public:
  using Maker = std::function<std::unique_ptr<Skill>(const Workbench&)>;
  // `staying`: what must not be moved for it, the action's own arguments above all. `nested`: how many things
  // are being moved for something else already. `again`: makes the skill anew, to try it in thought; may be
  // empty.
  RoomSkill(std::unique_ptr<Skill> doing, std::set<std::string> staying, int nested = 0, Maker again = {});
  Expected<Phases> attempt(Workbench& bench, int number) override;
  bool unfinished() const override { return moving_ != Moving::kNot || doing_->unfinished(); }

 private:
  enum class Moving { kNot, kTakes, kPuts };
  bool may_move_more() const;
  void begin_moving(const Workbench& bench, const InTheWay& what);
  void begin_putting_down(const std::string& thing, const std::optional<InTheWay>& what);
  std::optional<std::string> hindering(Workbench& bench) const;
  Expected<Phases> move(Workbench& bench, int number);

  std::unique_ptr<Skill> doing_;
  std::set<std::string> staying_;
  int nested_;
  Maker again_;
  Moving moving_ = Moving::kNot;
  std::string aside_;  // what is moved, or was
  std::unique_ptr<Skill> take_, put_;
  int moved_ = 0;
  int last_number_ = 0, failed_attempts_ = 0;
};

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
  // `only`: tags of the ways that may be taken (see grasp_reaches); empty: all.
  explicit GraspSkill(std::string object, std::set<std::size_t> only = {})
      : object_(std::move(object)), only_(std::move(only)) {}
  Expected<Phases> attempt(Workbench& bench, int number) override;
  bool unfinished() const override { return drags_; }

 private:
  Expected<Reach> find_way(Phases& phases, Workbench& bench) const;
  Expected<Phases> drag(Workbench& bench);

  std::string object_;
  std::set<std::size_t> only_;
  std::set<std::size_t> failed_;  // tags of ways that did not work
  bool drags_ = false;            // what attempt() returned only drags it to where it can be taken
  int dragged_ = 0;
};

// Whatever is done with what a hand holds. If it cannot be done with the grip that the hand has, but could
// with another, the thing is put down on the nearest worktop and taken anew, once. If it cannot be done where
// the thing is that it is done to (there is no room under the tap, or in the other hand), the other hand puts
// that on the nearest worktop, once. What stands where the held thing has to go is put aside in the same way.
class HeldSkill : public Skill {
 public:
  Expected<Phases> attempt(Workbench& bench, int number) final;
  bool unfinished() const final { return takes_anew_ || moving_ != Moving::kNot || only_prepared_; }

 protected:
  // `what`: the action, for messages. `receiver`: the movable thing that it is done to; may be empty.
  HeldSkill(std::string what, std::string held, std::string receiver = "")
      : what_(std::move(what)), held_(std::move(held)), receiver_(std::move(receiver)) {}
  // The next way to do it with the arm that holds the thing; marks it in failed_.
  virtual Expected<Phases> use(Workbench& bench, std::size_t arm) = 0;
  virtual bool another_grip_may_help(const Workbench&) const { return true; }
  // When no way was found, with no grip: whether use() will now do with less than what would be best.
  virtual bool does_with_less() { return false; }
  // What has to be put aside first, and how; empty: nothing. With both hands full, one is freed for it.
  virtual std::unique_ptr<Skill> make_room(const Workbench&, std::string&) const { return nullptr; }

  const std::string what_, held_, receiver_;
  std::set<std::size_t> failed_;  // tags of ways that did not work
  bool only_prepared_ = false;    // set by use(): what it returned makes room, and it wants to be asked again

 private:
  // Of something that is moved out of the way with the other hand.
  enum class Moving { kNot, kTakes, kPuts };

  std::set<std::size_t> other_grips(Workbench& bench, std::size_t arm);
  bool receiver_may_move(const Workbench& bench) const;
  void begin_moving(std::string thing, std::unique_ptr<Skill> put);
  Expected<Phases> move_aside(Workbench& bench, int number);

  std::unique_ptr<Skill> take_;  // with another grip, after it was put down
  bool takes_anew_ = false;
  Moving moving_ = Moving::kNot;
  std::string aside_;  // what is moved, or was
  int rooms_made_ = 0;
  bool asked_for_hand_ = false;  // with both full, to make room
  std::unique_ptr<Skill> take_aside_, put_aside_;
};

struct PlaceWay;

// keep-on / keep-in x place, release x (any free surface), stow x (the tray).
class PlaceSkill : public HeldSkill {
 public:
  // kAside: in the region, but not where water runs.
  enum class Where { kRegion, kAside, kNearest, kTray };
  // With kNearest, `region` is one that will do besides worktops; may be empty. `keep_clear` [m, map frame]:
  // not near there.
  PlaceSkill(std::string object, Where where, std::string region,
             std::optional<Eigen::Vector3d> keep_clear = std::nullopt)
      : HeldSkill("put down " + object, object),
        where_(where),
        region_(std::move(region)),
        keep_clear_(std::move(keep_clear)) {}

 private:
  friend class HeldSkill;  // puts down what it takes anew
  Expected<Phases> use(Workbench& bench, std::size_t arm) override;
  bool another_grip_may_help(const Workbench&) const override { return where_ == Where::kRegion; }
  std::unique_ptr<Skill> make_room(const Workbench& bench, std::string& occupant) const override;
  bool does_with_less() override {
    did_with_less_ = true;
    return std::exchange(wants_stream_, false);
  }

  bool runs_into(const Workbench& bench, const PlaceWay& way) const;
  Expected<Phases> step_back(Workbench& bench);
  // `turn`: as from other_end(); null: upright.
  std::vector<PlaceWay> find_ways(Workbench& bench, std::size_t arm, const Pose* turn = nullptr) const;

  Where where_;
  std::string region_;
  std::optional<Eigen::Vector3d> keep_clear_;
  bool stepped_back_ = false;
  bool wants_stream_ = false;  // where water runs it is put under it, or else not at all
  bool did_with_less_ = false;
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
class GestureSkill : public HeldSkill {
 public:
  enum class Kind { kPour, kScoop };
  // `receiver` empty: the sink.
  GestureSkill(const Action& action, Kind kind, std::string tool, std::string receiver)
      : HeldSkill(to_string(action), std::move(tool), std::move(receiver)), kind_(kind) {}

 private:
  Expected<Phases> use(Workbench& bench, std::size_t arm) override;
  bool another_grip_may_help(const Workbench& bench) const override;
  std::vector<Reach> ways(const Workbench& bench, std::size_t arm, const Pose& mouth, double beside,
                          bool reserve) const;

  Kind kind_;
};

// keep-in a bin or bag, keep-on a plate, add what is not poured, place-utensil, insert: into or onto another
// movable thing.
class PutSkill : public HeldSkill {
 public:
  PutSkill(const Action& action, std::string object, std::string receiver)
      : HeldSkill(to_string(action), std::move(object), std::move(receiver)) {}

 private:
  Expected<Phases> use(Workbench& bench, std::size_t arm) override;
  Expected<std::vector<Reach>> ways(Workbench& bench, std::size_t arm, const Pose& receiver) const;
};

// fill v source: what a hand holds is held under the running outlet of a fixture.
class FillSkill : public HeldSkill {
 public:
  FillSkill(const std::string& vessel, const scene::FillRule& outlet)
      : HeldSkill("fill " + vessel + " " + outlet.fixture, vessel), outlet_(outlet) {}

 private:
  Expected<Phases> use(Workbench& bench, std::size_t arm) override;

  scene::FillRule outlet_;
};

// open a bag: one hand holds it, the other takes its top between the fingers and pulls.
class TearSkill : public HeldSkill {
 public:
  explicit TearSkill(const std::string& object) : HeldSkill("open " + object, object) {}

 private:
  Expected<Phases> use(Workbench& bench, std::size_t arm) override;
};

// Ways to take hold of an object with any empty hand: those that the scene lists, or (`by_shape`) those that
// shape_grasps() finds for how it lies. Tags: arm * 10'000 + number of the candidate, + kByShape for the
// latter.
constexpr std::size_t kByShape = 5'000;
std::vector<Reach> grasp_reaches(Workbench& bench, const std::string& object, bool by_shape = false);
// Ways to take hold of a moving part.
std::vector<Reach> part_reaches(Workbench& bench, const scene::Scene::PartRef& ref);
// Ways to press a button with closed fingers.
std::vector<Reach> press_reaches(Workbench& bench, const scene::Scene::PartRef& ref);
// Ways to press a spot on a movable thing that lies about, with closed fingers from above.
std::vector<Reach> spot_reaches(Workbench& bench, const scene::ButtonRule& spot);
// Standing before a fixture or region, hands in front of it: for moveto.
std::vector<Reach> front_reaches(Workbench& bench, const std::string& place);
bool has_free_hand(const Workbench& bench);
// Large surfaces, free all around, on which nobody minds what is put down for a while.
bool is_worktop(const scene::Scene& scene, const scene::Region& region);
// The region, if any, in whose supports an object is, by geometry.
const scene::Region* region_around(const Workbench& bench, const Pose& object);

}  // namespace goalnet::manipulation

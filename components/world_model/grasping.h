// Which hand holds what, seen from outside: material of the object touches both finger pads, and it moves
// with them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/robot/robot_model.h"
#include "components/scene/scene.h"
#include "components/world_model/params.h"
#include "components/world_model/support.h"

namespace goalnet::world_model {

// One hand at one moment. Pads: the first finger's at +y of the tool frame, the second's at -y.
struct HandView {
  bool known = false;
  scene::Pose tool = scene::Pose::Identity();  // in the map frame: z out of the hand, y the closing direction
  double first = 0.0, second = 0.0;            // [m] from the middle to each pad
};

class Grasping {
 public:
  Grasping(const scene::Scene& scene, const robot::RobotModel& robot, const Params& params);

  // `hands` in the order of RobotModel::arms, `objects` in that of Scene::objects. `time_ns` never goes back.
  void update(std::int64_t time_ns, const std::vector<HandView>& hands,
              const std::vector<ObjectView>& objects);
  // The object that each hand holds.
  const std::vector<std::optional<std::size_t>>& held() const { return held_; }

 private:
  // How far the material between the fingers falls short of the worse pad [m]; nothing if there is none.
  std::optional<double> finger_gap(std::size_t arm, const HandView& hand, std::size_t object,
                                   const ObjectView& view) const;
  struct Candidate {
    std::optional<std::size_t> object;
    std::int64_t since_ns = 0;
    Eigen::Vector3d in_hand = Eigen::Vector3d::Zero();  // origin of the object in the tool frame
  };

  const scene::Scene& scene_;
  const robot::RobotModel& robot_;
  const Params& params_;
  std::vector<Candidate> candidates_;
  std::vector<std::optional<std::size_t>> held_;
};

}  // namespace goalnet::world_model

#include "components/scene/scene.h"

#include <algorithm>

namespace goalnet::scene {
namespace {

template <class List>
auto find_by_name(const List& list, std::string_view name) -> decltype(list.data()) {
  for (const auto& entry : list) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

// splitmix64: tiny, and the same on every machine, unlike the distributions of <random>.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  // Uniform in [-1, 1).
  double symmetric() {
    state_ += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1.0p-52 - 1.0;
  }

 private:
  std::uint64_t state_;
};

}  // namespace

const Object* Scene::find_object(std::string_view object_name) const {
  return find_by_name(objects, object_name);
}

const ObjectModel* Scene::find_model_of(std::string_view object_name) const {
  const Object* object = find_object(object_name);
  return object == nullptr ? nullptr : &models[object->model];
}

const Fixture* Scene::find_fixture(std::string_view fixture_name) const {
  return find_by_name(fixtures, fixture_name);
}

const Region* Scene::find_region(std::string_view region_name) const {
  return find_by_name(regions, region_name);
}

Scene::PartRef Scene::find_part(std::string_view part_name) const {
  for (const auto& fixture : fixtures) {
    for (const auto& part : fixture.parts) {
      if (part.name == part_name) return {&fixture, &part};
    }
  }
  for (const auto& fixture : fixtures) {
    for (const auto& part : fixture.parts) {
      if (part.action_object == part_name) return {&fixture, &part};
    }
  }
  return {};
}

Scene::PartRef Scene::find_joint(std::string_view joint_name) const {
  for (const auto& fixture : fixtures) {
    for (const auto& part : fixture.parts) {
      if (part.joint.name == joint_name) return {&fixture, &part};
    }
  }
  return {};
}

std::vector<Pose> initial_poses(const Scene& scene, std::uint64_t seed) {
  std::vector<Pose> poses;
  poses.reserve(scene.objects.size());
  Random random(seed);
  for (const auto& object : scene.objects) {
    const Placement& placement = object.placement;
    // Drawn for every object, also fixed ones, so that one object's settings do not change the others' poses.
    const double dx = random.symmetric() * placement.jitter_xy;
    const double dy = random.symmetric() * placement.jitter_xy;
    const double dyaw = random.symmetric() * placement.jitter_yaw;
    Pose pose = placement.pose;
    if (seed != 0) {
      pose.translation() += Eigen::Vector3d(dx, dy, 0.0);
      pose.linear() = Eigen::AngleAxisd(dyaw, Eigen::Vector3d::UnitZ()).toRotationMatrix() * pose.linear();
    }
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace goalnet::scene

// Where each object stands: on a surface, in a container, on or in another object, on the robot's tray.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "components/scene/scene.h"
#include "components/world_model/params.h"

namespace goalnet::world_model {

// One object at one moment.
struct ObjectView {
  bool known = false;                          // perceived lately
  bool held = false;                           // in a hand: then it stands nowhere
  bool resting = false;                        // slow, or slow against what carries it
  scene::Pose pose = scene::Pose::Identity();  // in the map frame
};

// What an object stands on or in. At most one place at a time.
struct Place {
  enum class Kind { kNone, kRegion, kOnObject, kInObject, kTray };
  Kind kind = Kind::kNone;
  std::size_t index = 0;    // of Scene::regions or Scene::objects
  std::size_t support = 0;  // of Region::supports
  bool operator==(const Place&) const = default;
};

// The robot's tray as a surface.
struct TrayView {
  bool present = false;
  scene::Pose pose = scene::Pose::Identity();  // z = 0 is the surface; in the map frame
  Eigen::Vector2d lower = Eigen::Vector2d::Zero(), upper = Eigen::Vector2d::Zero();  // [m] in its frame
};

// An object keeps its place while the loose thresholds hold; otherwise it gets the first that fits by the
// tight ones: a hollow object, another object, the tray, then the region with the least gap.
class Support {
 public:
  Support(const scene::Scene& scene, const Params& params);

  // `objects` in the order of Scene::objects.
  void update(const std::vector<ObjectView>& objects, const TrayView& tray);
  const std::vector<Place>& places() const { return places_; }
  // Things on this object lie in a hollow, if a shallow one: On and In both hold (an egg on and in a soup
  // plate).
  bool carries_in_hollow(std::size_t object) const;

 private:
  struct Extent {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // of the object's bounds, in the map frame
    double lowest = 0.0, highest = 0.0;                // [m]
  };
  bool fits(std::size_t object, const Place& place, bool loose, double* gap) const;
  bool on_surface(const Extent& extent, const scene::Pose& frame, const Eigen::Vector2d& lower,
                  const Eigen::Vector2d& upper, bool loose, double* gap) const;
  bool in_region(const Extent& extent, const scene::Pose& frame, const scene::Support& support,
                 bool loose) const;
  bool in_object(std::size_t object, std::size_t other, bool loose) const;
  bool on_object(std::size_t object, std::size_t other, bool loose, double* gap) const;
  Place find(std::size_t object) const;

  const scene::Scene& scene_;
  const Params& params_;
  std::vector<std::vector<scene::Pose>> support_frames_;  // of each region, in the map frame
  std::vector<double> footprint_radius_;
  std::vector<Eigen::Vector3d> middle_;  // of each object's bounds, in its own frame
  std::vector<ObjectView> objects_;
  std::vector<Extent> extents_;
  TrayView tray_;
  std::vector<Place> places_;
};

}  // namespace goalnet::world_model

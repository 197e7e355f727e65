#include <cmath>
#include <numbers>

#include "components/scene/load_parts.h"

namespace goalnet::scene {
namespace {

constexpr double kMaxLength = 50.0;    // [m]
constexpr double kMinLength = 0.0005;  // [m] thinner things make contacts unreliable

// A hollow cylinder (or, with `flare`, a cone that widens upwards) as a closed chain of boxes: outer radius
// at the top, wall thickness, height; axis z, centred.
void append_ring(const std::vector<double>& size, double flare, int segments, const Shape& prototype,
                 std::vector<Shape>& shapes) {
  const double outer = size[0], wall = size[1], height = size[2];
  const double half_angle = std::numbers::pi / segments;
  const double middle = outer - (wall / 2.0) / std::cos(flare) - height / 2.0 * std::tan(flare);
  for (int i = 0; i < segments; ++i) {
    Shape box = prototype;
    box.kind = ShapeKind::kBox;
    box.size = {wall, 2.0 * outer * std::tan(half_angle), height / std::cos(flare)};
    const double angle = 2.0 * half_angle * i;
    box.pose = prototype.pose * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) *
               Eigen::Translation3d(middle, 0.0, 0.0) * Eigen::AngleAxisd(flare, Eigen::Vector3d::UnitY());
    shapes.push_back(box);
  }
}

}  // namespace

Pose read_pose(YamlReader& reader) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return make_pose(reader.vector3("at", zero), kDegree * reader.vector3("rpy", zero));
}

std::vector<Shape> read_shapes(YamlReader& owner, const std::string& key) {
  std::vector<Shape> shapes;
  for (auto& reader : owner.maps(key)) {
    Shape shape;
    shape.pose = read_pose(reader);
    const auto color = reader.numbers("color", 3, 0.0, 1.0, std::vector<double>{0.7, 0.7, 0.7});
    shape.color = {color[0], color[1], color[2]};
    shape.solid = reader.flag("solid", true);
    const bool box = reader.has("box"), cylinder = reader.has("cylinder"), sphere = reader.has("sphere"),
               ring = reader.has("ring");
    if (box + cylinder + sphere + ring != 1) {
      reader.mistake(
          "a shape needs exactly one of box: [x, y, z], cylinder: [radius, length], sphere: [radius], "
          "ring: [outer radius, wall, height]");
    } else if (box) {
      const auto size = reader.numbers("box", 3, kMinLength, kMaxLength);
      shape.size = {size[0], size[1], size[2]};
      shapes.push_back(shape);
    } else if (cylinder) {
      const auto size = reader.numbers("cylinder", 2, kMinLength, kMaxLength);
      shape.kind = ShapeKind::kCylinder;
      shape.size = {size[0], size[0], size[1]};
      shapes.push_back(shape);
    } else if (sphere) {
      const auto size = reader.numbers("sphere", 1, kMinLength, kMaxLength);
      shape.kind = ShapeKind::kSphere;
      shape.size = Eigen::Vector3d::Constant(size[0]);
      shapes.push_back(shape);
    } else {
      const auto size = reader.numbers("ring", 3, kMinLength, kMaxLength);
      const int segments = static_cast<int>(reader.number("segments", 6, 48, 12));
      if (size[1] >= size[0]) reader.mistake_at("ring", "the wall of a ring must be thinner than its radius");
      const double flare = kDegree * reader.number("flare", 0.0, 60.0, 0.0);
      if (size[0] - size[1] - size[2] * std::tan(flare) < 0.002) {
        reader.mistake_at("ring", "this ring closes at its bottom; use a larger radius or less flare");
      }
      append_ring(size, flare, segments, shape, shapes);
    }
    reader.finish();
  }
  if (shapes.size() > 500) owner.mistake_at(key, "more than 500 shapes in one body; make it simpler");
  return shapes;
}

std::vector<Grasp> read_grasps(YamlReader& owner) {
  std::vector<Grasp> grasps;
  for (auto& reader : owner.maps("grasps")) {
    Grasp grasp;
    grasp.name = reader.text("name");
    const std::string kind = reader.choice("kind", {"around", "rim", "pinch"});
    grasp.kind = kind == "around" ? GraspKind::kAround : kind == "rim" ? GraspKind::kRim : GraspKind::kPinch;
    grasp.frame = read_pose(reader);
    grasp.width = reader.number("width", 0.0005, 0.3);
    grasp.open_width = reader.number("open_width", grasp.width, 0.5, grasp.width + 0.05);
    grasp.depth = reader.number("depth", 0.0, 0.2, 0.02);
    grasp.tilt_max = kDegree * reader.number("tilt", 0.0, 90.0, 0.0);
    if (grasp.kind == GraspKind::kRim) {
      grasp.radius = reader.number("radius", 0.005, 1.0);
    } else {
      const auto span = reader.numbers("span", 2, -1.0, 1.0, std::vector<double>{0.0, 0.0});
      grasp.low = span[0];
      grasp.high = span[1];
    }
    const std::vector<double> all_round =
        grasp.kind == GraspKind::kPinch ? std::vector<double>{0.0, 0.0} : std::vector<double>{-180.0, 180.0};
    const auto angles = reader.numbers("angles", 2, -360.0, 360.0, all_round);
    grasp.angle_min = kDegree * angles[0];
    grasp.angle_max = kDegree * angles[1];
    if (grasp.high < grasp.low) reader.mistake_at("span", "'span' must be [low, high]");
    if (grasp.angle_max < grasp.angle_min) reader.mistake_at("angles", "'angles' must be [least, greatest]");
    reader.finish();
    grasps.push_back(grasp);
  }
  return grasps;
}

}  // namespace goalnet::scene

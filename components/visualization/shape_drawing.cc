#include "components/visualization/shape_drawing.h"

namespace goalnet::visualization {
namespace {

Drawing draw(const scene::Shape& shape, const Pose& owner) {
  Drawing drawing;
  drawing.pose = owner * shape.pose;
  drawing.size = shape.size;
  switch (shape.kind) {
    case scene::ShapeKind::kBox:
      drawing.kind = DrawingKind::kBox;
      break;
    case scene::ShapeKind::kCylinder:
      drawing.kind = DrawingKind::kCylinder;
      drawing.size.head<2>() *= 2.0;  // the scene has radii
      break;
    case scene::ShapeKind::kSphere:
      drawing.kind = DrawingKind::kSphere;
      drawing.size *= 2.0;
      break;
  }
  for (std::size_t i = 0; i < 3; ++i) drawing.color[i] = static_cast<float>(shape.color[i]);
  drawing.color[3] = shape.solid ? 1.0f : 0.5f;
  return drawing;
}

// Ids count on whether or not there is a pose: they name shapes, not what happens to be seen.
void draw_all(const std::vector<scene::Shape>& shapes, const Pose* owner, const char* group, std::int32_t& id,
              std::vector<Drawing>& out) {
  for (const scene::Shape& shape : shapes) {
    const std::int32_t its_id = id++;
    if (owner == nullptr) continue;
    Drawing drawing = draw(shape, *owner);
    drawing.group = group;
    drawing.id = its_id;
    out.push_back(std::move(drawing));
  }
}

const Pose* find(const Poses& poses, const std::string& name) {
  const auto found = poses.find(name);
  return found == poses.end() ? nullptr : &found->second;
}

// The highest point of the shapes' bounding box, above its middle.
Eigen::Vector3d top_of(const std::vector<scene::Shape>& shapes, const Pose& owner) {
  const scene::Bounds box = scene::bounds(shapes);
  double highest = owner.translation().z();
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point(corner & 1 ? box.upper.x() : box.lower.x(),
                                corner & 2 ? box.upper.y() : box.lower.y(),
                                corner & 4 ? box.upper.z() : box.lower.z());
    highest = std::max(highest, (owner * point).z());
  }
  Eigen::Vector3d middle = owner * (0.5 * (box.lower + box.upper));
  middle.z() = highest;
  return middle;
}

}  // namespace

void draw_shapes(const scene::Scene& scene, const Poses& poses, std::vector<Drawing>& out) {
  std::int32_t fixture_id = 0, part_id = 0, object_id = 0;
  for (const scene::Fixture& fixture : scene.fixtures) {
    draw_all(fixture.shapes, &fixture.pose, "fixtures", fixture_id, out);
    for (const scene::Part& part : fixture.parts)
      draw_all(part.shapes, find(poses, part.name), "parts", part_id, out);
  }
  for (const scene::Object& object : scene.objects)
    draw_all(scene.model_of(object).shapes, find(poses, object.name), "objects", object_id, out);
}

bool place_above(const scene::Scene& scene, const Poses& poses, const std::string& name,
                 Eigen::Vector3d& place) {
  if (const scene::ObjectModel* model = scene.find_model_of(name)) {
    const Pose* pose = find(poses, name);
    if (pose == nullptr) return false;
    place = top_of(model->shapes, *pose);
    return true;
  }
  if (const auto part = scene.find_part(name); part && part.part->name == name) {
    const Pose* pose = find(poses, name);
    if (pose == nullptr) return false;
    place = top_of(part.part->shapes, *pose);
    return true;
  }
  if (const scene::Fixture* fixture = scene.find_fixture(name)) {
    place = top_of(fixture->shapes, fixture->pose);
    return true;
  }
  if (const scene::Region* region = scene.find_region(name); region != nullptr && !region->supports.empty()) {
    const scene::Fixture* fixture = scene.find_fixture(region->fixture);
    if (fixture == nullptr) return false;
    place = (fixture->pose * region->supports.front().frame).translation();
    return true;
  }
  return false;
}

}  // namespace goalnet::visualization

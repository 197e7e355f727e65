// What is drawn, without DDS: each drawing becomes one visualization_msgs/Marker.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace goalnet::visualization {

using Pose = Eigen::Isometry3d;  // metres, in the map frame

enum class DrawingKind { kBox, kSphere, kCylinder, kLine, kText };

struct Drawing {
  std::string group;  // objects, facts, ...; group and id name a drawing as long as the scene is the same
  std::int32_t id = 0;
  DrawingKind kind = DrawingKind::kBox;
  Pose pose = Pose::Identity();  // of the shape's centre; the line's points are in this frame
  // Box: edge lengths. Sphere: diameter three times. Cylinder: diameter, diameter, length along z. Line:
  // width in x. Text: height of a capital letter in z. [m]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  std::array<float, 4> color = {0.7f, 0.7f, 0.7f, 1.0f};  // red, green, blue, opacity 0..1
  std::vector<Eigen::Vector3d> points;                    // [m] of a line
  std::string text;
};

}  // namespace goalnet::visualization

#include "components/visualization/marker_message.h"

namespace goalnet::visualization {
namespace {

using visualization_msgs::msg::Marker;

std::int32_t marker_type(DrawingKind kind) {
  switch (kind) {
    case DrawingKind::kBox:
      return visualization_msgs::msg::Marker_Constants::CUBE;
    case DrawingKind::kSphere:
      return visualization_msgs::msg::Marker_Constants::SPHERE;
    case DrawingKind::kCylinder:
      return visualization_msgs::msg::Marker_Constants::CYLINDER;
    case DrawingKind::kLine:
      return visualization_msgs::msg::Marker_Constants::LINE_STRIP;
    case DrawingKind::kText:
      return visualization_msgs::msg::Marker_Constants::TEXT_VIEW_FACING;
  }
  return visualization_msgs::msg::Marker_Constants::CUBE;
}

Marker begin(const std::string& group, std::int32_t id, const builtin_interfaces::msg::Time& stamp) {
  Marker marker;
  marker.header().frame_id("map");
  marker.header().stamp(stamp);
  marker.ns(group);
  marker.id(id);
  marker.pose().orientation().w(1.0);
  return marker;
}

Marker to_marker(const Drawing& drawing, const builtin_interfaces::msg::Time& stamp) {
  Marker marker = begin(drawing.group, drawing.id, stamp);
  marker.type(marker_type(drawing.kind));
  marker.action(visualization_msgs::msg::Marker_Constants::ADD);
  const Eigen::Vector3d at = drawing.pose.translation();
  const Eigen::Quaterniond turn(drawing.pose.linear());
  marker.pose().position().x(at.x());
  marker.pose().position().y(at.y());
  marker.pose().position().z(at.z());
  marker.pose().orientation().x(turn.x());
  marker.pose().orientation().y(turn.y());
  marker.pose().orientation().z(turn.z());
  marker.pose().orientation().w(turn.w());
  marker.scale().x(drawing.size.x());
  marker.scale().y(drawing.size.y());
  marker.scale().z(drawing.size.z());
  marker.color().r(drawing.color[0]);
  marker.color().g(drawing.color[1]);
  marker.color().b(drawing.color[2]);
  marker.color().a(drawing.color[3]);
  for (const Eigen::Vector3d& point : drawing.points) {
    geometry_msgs::msg::Point one;
    one.x(point.x());
    one.y(point.y());
    one.z(point.z());
    marker.points().push_back(one);
  }
  marker.text(drawing.text);
  return marker;
}

}  // namespace

visualization_msgs::msg::MarkerArray MarkerWriter::write(const std::vector<Drawing>& drawings,
                                                         const builtin_interfaces::msg::Time& stamp) {
  visualization_msgs::msg::MarkerArray message;
  std::set<std::pair<std::string, std::int32_t>> there;
  for (const Drawing& drawing : drawings) {
    there.emplace(drawing.group, drawing.id);
    message.markers().push_back(to_marker(drawing, stamp));
  }
  for (const auto& [group, id] : ever_) {
    if (there.contains({group, id})) continue;
    Marker marker = begin(group, id, stamp);
    marker.action(visualization_msgs::msg::Marker_Constants::DELETE);
    message.markers().push_back(std::move(marker));
  }
  ever_.merge(there);
  return message;
}

}  // namespace goalnet::visualization

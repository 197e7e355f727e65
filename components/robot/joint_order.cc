#include "components/robot/joint_order.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <set>
#include <string_view>

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

namespace goalnet::robot {
namespace {

constexpr double kFarthest = 1e3;  // [m] nothing of a robot is farther from its parent, or larger
constexpr std::size_t kMaxNesting = 1000;

// What urdfdom complains of while this lives. It leaves out an element that it cannot read, prints a line and
// goes on: a link would have no collision shape, or no mass, and nobody would know.
class Complaints : public console_bridge::OutputHandler {
 public:
  Complaints() : lock_(one_at_a_time()) { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }

  void log(const std::string& what, console_bridge::LogLevel level, const char*, int) override {
    constexpr std::size_t kMost = 400;
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || text_.size() > kMost) return;
    text_ += (text_.empty() ? "" : "; ") + what.substr(0, kMost);
  }
  const std::string& text() const { return text_; }

 private:
  static std::mutex& one_at_a_time() {
    static std::mutex mutex;  // console_bridge has one handler for all threads
    return mutex;
  }
  std::lock_guard<std::mutex> lock_;
  std::string text_;
};

bool finite(const urdf::Pose& pose) {
  const auto& p = pose.position;
  const auto& r = pose.rotation;
  const double norm = r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w;
  const double distance = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
  return distance <= kFarthest && std::isfinite(norm) && std::abs(norm - 1.0) < 1e-6;
}

// How deep elements stand in each other, about: text in comments counts as well.
std::size_t nesting(const std::string& xml) {
  std::size_t deepest = 0, depth = 0;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::string_view element(xml.data() + at, std::min(xml.find('>', at), xml.size()) - at);
    if (element.starts_with("</")) {
      depth -= depth > 0 ? 1 : 0;
    } else if (!element.starts_with("<!") && !element.starts_with("<?") && !element.ends_with('/')) {
      deepest = std::max(deepest, ++depth);
    }
  }
  return deepest;
}

// A link that is the child of two joints, or "". urdfdom accepts it: whoever follows the joints would go
// round in a loop for ever, or meet the same link again and again.
std::string child_of_two(const urdf::ModelInterface& model) {
  std::set<std::string> children;
  for (const auto& [name, joint] : model.joints_)
    if (!children.insert(joint->child_link_name).second) return joint->child_link_name;
  return "";
}

// Links own their children: those of a loop would own each other, and never be freed.
void take_apart(urdf::ModelInterface& model) {
  for (const auto& [name, link] : model.links_) link->child_links.clear(), link->child_joints.clear();
}

std::string check_joint(const urdf::Joint& joint) {
  if (!finite(joint.parent_to_joint_origin_transform))
    return "has an origin that is not a finite pose within 1 km";
  if (joint.type == urdf::Joint::FIXED) return "";
  if (joint.type != urdf::Joint::REVOLUTE && joint.type != urdf::Joint::CONTINUOUS &&
      joint.type != urdf::Joint::PRISMATIC) {
    return "is neither fixed, revolute, continuous nor prismatic";
  }
  const auto& a = joint.axis;
  const double norm = std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
  if (!std::isfinite(norm) || std::abs(norm - 1.0) > 1e-6) return "has an axis that is not of unit length";
  if (!joint.limits) return "has no <limit>";
  const auto& l = *joint.limits;
  if (!std::isfinite(l.lower) || !std::isfinite(l.upper) || !std::isfinite(l.velocity) ||
      !std::isfinite(l.effort)) {
    return "has limits that are not finite";
  }
  if (joint.type != urdf::Joint::CONTINUOUS && l.lower > l.upper)
    return "has a lower limit above its upper one";
  if (l.velocity <= 0 || l.effort <= 0) return "needs a velocity and an effort limit above zero";
  if (joint.mimic) return "mimics another; give it its own entry in the gripper's fingers instead";
  return "";
}

std::string check_inertia(const urdf::Link& link) {
  if (!link.inertial) return "";
  const auto& i = *link.inertial;
  if (!std::isfinite(i.mass) || i.mass < 0) return "has a mass that is negative or not finite";
  if (!finite(i.origin)) return "has an inertial origin that is not a finite pose within 1 km";
  for (double v : {i.ixx, i.iyy, i.izz, i.ixy, i.ixz, i.iyz}) {
    if (!std::isfinite(v)) return "has an inertia that is not finite";
  }
  if (i.ixx < 0 || i.iyy < 0 || i.izz < 0) return "has a negative moment of inertia";
  return "";
}

std::string check_collision(const urdf::Collision& collision) {
  if (!finite(collision.origin)) return "has a <collision> whose origin is not a finite pose within 1 km";
  std::vector<double> sizes;
  if (const auto* box = dynamic_cast<const urdf::Box*>(collision.geometry.get())) {
    sizes = {box->dim.x, box->dim.y, box->dim.z};
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(collision.geometry.get())) {
    sizes = {cylinder->radius, cylinder->length};
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(collision.geometry.get())) {
    sizes = {sphere->radius};
  } else {
    return "has a <collision> that is neither box, cylinder nor sphere; approximate it with those";
  }
  for (const double size : sizes) {
    if (!(size > 0.0 && size <= kFarthest)) return "has a <collision> with a size outside 0 .. 1 km";
  }
  return "";
}

std::string check_link(const urdf::Link& link) {
  if (const auto what = check_inertia(link); !what.empty()) return what;
  for (const auto& collision : link.collision_array) {
    if (const auto what = check_collision(*collision); !what.empty()) return what;
  }
  return "";
}

}  // namespace

bool is_actuated(const urdf::Joint& joint) { return joint.type != urdf::Joint::FIXED; }

std::vector<urdf::JointConstSharedPtr> joints_depth_first(const urdf::ModelInterface& model) {
  std::vector<urdf::JointConstSharedPtr> order;
  std::function<void(const urdf::LinkConstSharedPtr&)> visit = [&](const urdf::LinkConstSharedPtr& link) {
    for (const auto& joint : link->child_joints) {
      order.push_back(joint);
      visit(model.getLink(joint->child_link_name));
    }
  };
  visit(model.getRoot());
  return order;
}

Expected<urdf::ModelInterfaceSharedPtr> parse_urdf(const std::string& xml, const std::string& file_name) {
  const auto bad = [&](const std::string& what) {
    return fail(Outcome::kInvalidRequest, file_name + ": " + what);
  };
  if (xml.size() > (4u << 20))
    return bad("larger than 4 MB; a robot description is text with primitive shapes");
  if (nesting(xml) > kMaxNesting)  // urdfdom's reader takes minutes, or all of the stack
    return bad("elements stand in each other more than " + std::to_string(kMaxNesting) + " deep");
  urdf::ModelInterfaceSharedPtr model;
  const Complaints complaints;
  try {
    model = urdf::parseURDF(xml);
  } catch (const std::exception& e) {
    return bad(std::string("urdfdom cannot read it: ") + e.what());
  }
  if (!complaints.text().empty()) return bad("not a valid URDF: " + complaints.text());
  if (!model || !model->getRoot())
    return bad("not a valid URDF: XML malformed, or a link or joint is missing or repeated");
  if (model->links_.size() > kMaxLinks) return bad("more than " + std::to_string(kMaxLinks) + " links");
  if (const auto link = child_of_two(*model); !link.empty()) {
    take_apart(*model);
    return bad("link '" + link + "' is the child of two joints; the links must form one tree");
  }
  const auto joints = joints_depth_first(*model);
  if (joints.size() + 1 != model->links_.size()) {
    take_apart(*model);
    return bad("its links do not form one tree");
  }
  for (const auto& joint : joints) {
    if (const auto what = check_joint(*joint); !what.empty())
      return bad("joint '" + joint->name + "' " + what);
  }
  for (const auto& [name, link] : model->links_) {
    if (const auto what = check_link(*link); !what.empty()) return bad("link '" + name + "' " + what);
  }
  return model;
}

}  // namespace goalnet::robot

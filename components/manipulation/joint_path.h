// Smooth curves through joint space, before they get their times.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace goalnet::manipulation {

// Configurations of some joints [rad or m], in a fixed order known to the caller.
using JointVector = Eigen::VectorXd;
using JointPath = std::vector<JointVector>;

using IsFree = std::function<bool(const JointVector&)>;

// How dense paths are made for timing: [s] at full speed between neighbouring points.
inline constexpr double kPathSpacing = 0.02;

// Rounds the corners of a polyline with parabolas that begin and end at most `reach` from the corner (in
// units of `scale`, a weight per joint) and never beyond the middle of a leg. A parabola that is not free is
// made smaller, down to nothing. The result is dense: neighbouring points are at most `spacing` apart. The
// polyline itself must be free already.
JointPath round_corners(const JointPath& corners, const JointVector& scale, double reach, double spacing,
                        const IsFree& is_free);

// A dense curve with continuous slope through all points (centripetal Catmull-Rom): for points that follow a
// line of the tool. Neighbouring points must be near each other already. Where the points turn sharply the
// curve has a corner: rounded, it would swing out towards what the line kept clear of.
JointPath through_points(const JointPath& points, const JointVector& scale, double spacing);

// Whether a path turns by more than 60 degrees at a point. Nothing with mass goes round such a corner:
// time_path stops there.
bool turns_sharply(const JointVector& before, const JointVector& at, const JointVector& after,
                   const JointVector& scale);

// Largest scaled difference of any joint.
double scaled_distance(const JointVector& a, const JointVector& b, const JointVector& scale);

}  // namespace goalnet::manipulation

#pragma once
/// Text formats of numbers and bodies for other discrete element codes.
#include <string>

#include "study/engines/detail/scene.hpp"

namespace clast::study_detail {

/// Formats a number with the fewest digits that represent it exactly.
std::string format_exact(double value);
/// Formats a point as "x y z".
std::string format_exact(const Vec3& v);

/// Formats a body as a line of a conf file: name, group, cluster, homothety, position, velocity,
/// acceleration, orientation (w x y z), angular velocity and angular acceleration in world axes.
std::string format_conf_line(const std::string& shape, std::uint32_t group, double scale,
                             const RigidState& start);

}  // namespace clast::study_detail

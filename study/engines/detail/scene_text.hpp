#pragma once
/// Numbers and bodies in the text files of other engines.
#include <string>

#include "study/engines/detail/scene.hpp"

namespace clast::study_detail {

/// The fewest digits that are read as the same bits.
std::string exact(double value);
/// "x y z"
std::string exact(const Vec3& v);

/// Bodies as lines of a conf file: name, group, cluster, homothety, position, velocity,
/// acceleration, orientation (w x y z), angular velocity and acceleration, in world axes.
std::string format_conf_line(const std::string& shape, std::uint32_t group, double scale,
                      const RigidState& start);

}  // namespace clast::study_detail

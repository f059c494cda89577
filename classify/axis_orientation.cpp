#include "classify/axis_orientation.hpp"

#include <cmath>

namespace clast {

AxisOrientation axis_orientation(const Vec3& axis) {
  Vec3 down = axis;
  if (down.z() > 0.0) down = -down;
  if (down.z() == 0.0 && (down.x() < 0.0 || (down.x() == 0.0 && down.y() < 0.0))) down = -down;
  const double horizontal = std::hypot(down.x(), down.y());
  AxisOrientation orientation;
  orientation.plunge = std::atan2(-down.z(), horizontal);
  if (horizontal > 0.0) orientation.trend = std::atan2(down.x(), down.y());
  if (orientation.trend < 0.0) orientation.trend += 2.0 * kPi;
  return orientation;
}

}  // namespace clast

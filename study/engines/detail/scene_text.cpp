#include "study/engines/detail/scene_text.hpp"

#include <array>
#include <charconv>

namespace clast::study_detail {

std::string format_exact(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string format_exact(const Vec3& v) {
  return format_exact(v.x()) + " " + format_exact(v.y()) + " " + format_exact(v.z());
}

std::string format_conf_line(const std::string& shape, std::uint32_t group, double scale,
                             const RigidState& start) {
  const Quat& turn = start.orientation;
  const std::string none = "0 0 0";
  return shape + " " + std::to_string(group) + " 0 " + format_exact(scale) + "  " +
         format_exact(start.position) + "  " + format_exact(start.velocity) + "  " + none + "  " +
         format_exact(turn.w()) + " " + format_exact(Vec3(turn.vec())) + "  " +
         format_exact(start.angular_velocity) + "  " + none + "\n";
}

}  // namespace clast::study_detail

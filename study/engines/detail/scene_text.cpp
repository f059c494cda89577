#include "study/engines/detail/scene_text.hpp"

#include <array>
#include <charconv>

namespace clast::study_detail {

std::string exact(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string exact(const Vec3& v) { return exact(v.x()) + " " + exact(v.y()) + " " + exact(v.z()); }

std::string format_conf_line(const std::string& shape, std::uint32_t group, double scale,
                      const RigidState& start) {
  const Quat& turn = start.orientation;
  const std::string none = "0 0 0";
  return shape + " " + std::to_string(group) + " 0 " + exact(scale) + "  " + exact(start.position) +
         "  " + exact(start.velocity) + "  " + none + "  " + exact(turn.w()) + " " +
         exact(Vec3(turn.vec())) + "  " + exact(start.angular_velocity) + "  " + none + "\n";
}

}  // namespace clast::study_detail

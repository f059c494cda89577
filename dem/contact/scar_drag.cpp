#include "dem/contact/scar_drag.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace clast::dem_detail {
namespace {

/// Embedded frontal area of a ball with its lowest point `depth` below the plane.
EmbeddedFrontalArea embedded_ball(const Vec3& centre, double radius, double depth, const Vec3& up) {
  if (!(depth > 0.0)) return {};
  const double half = std::acos(std::max(-1.0, 1.0 - depth / radius));
  const double sine = std::sin(half), fraction = half - sine * std::cos(half);
  if (!(fraction > 0.0)) return {};
  const double below = 2.0 / 3.0 * radius * sine * sine * sine / fraction;
  return {radius * radius * fraction, centre - below * up};
}

/// Part of a triangle below height 0.
struct Below {
  double area = 0.0;
  Vec3 moment = Vec3::Zero();  ///< area times centroid
};
Below part_below(const std::array<Vec3, 3>& corners, const std::array<double, 3>& heights) {
  std::array<Vec3, 4> kept;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (heights[i] < 0.0) kept[count++] = corners[i];
    if ((heights[i] < 0.0) != (heights[j] < 0.0)) {
      const double fraction = heights[i] / (heights[i] - heights[j]);
      kept[count++] = corners[i] + fraction * (corners[j] - corners[i]);
    }
  }
  Below below;
  for (std::size_t i = 2; i < count; ++i) {
    const double area = 0.5 * (kept[i - 1] - kept[0]).cross(kept[i] - kept[0]).norm();
    below.area += area;
    below.moment += area / 3.0 * (kept[0] + kept[i - 1] + kept[i]);
  }
  return below;
}

}  // namespace

EmbeddedFrontalArea embedded_frontal_area(const SurfaceFeatures& block, double radius,
                                          const Vec3& ground, const Vec3& up,
                                          const Vec3& direction) {
  const auto height = [&](const Vec3& point) { return up.dot(point - ground) - radius; };
  if (block.faces.empty()) {
    const auto lowest =
        std::min_element(block.vertices.begin(), block.vertices.end(),
                         [&](const Vec3& a, const Vec3& b) { return up.dot(a) < up.dot(b); });
    return embedded_ball(*lowest, radius, -height(*lowest), up);
  }
  EmbeddedFrontalArea front;
  Vec3 moment = Vec3::Zero();
  for (const SurfaceFace& face : block.faces) {
    const double facing = face.normal.dot(direction);
    if (!(facing > 0.0)) continue;
    std::array<Vec3, 3> corners;
    std::array<double, 3> heights{};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = block.vertices[face.vertices[i]];
      heights[i] = height(corners[i]);
    }
    if (*std::min_element(heights.begin(), heights.end()) >= 0.0) continue;
    const Below below = part_below(corners, heights);
    front.area += facing * below.area;
    moment += facing * below.moment;
  }
  if (front.area > 0.0) front.centre = moment / front.area - radius * up;
  return front;
}

Vec3 ScarDrag::update(const std::vector<Contact>& contacts, const RelativeMotion& motion,
                      double& lost) {
  lost = -0.5 * motion.duration * force_.dot(motion.velocity_of_start_point(position_));
  force_ = drag_force(contacts, motion);
  lost -= 0.5 * motion.duration * force_.dot(motion.velocity_at(position_));
  return force_;
}

Vec3 ScarDrag::drag_force(const std::vector<Contact>& contacts, const RelativeMotion& motion) {
  // The ground is the mean plane of all contacts.
  double weight = 0.0, drag_factors = 0.0;
  Vec3 up = Vec3::Zero(), foot = Vec3::Zero();
  for (const Contact& contact : contacts) {
    weight += contact.weight;
    drag_factors += contact.weight * drag_factors_[contact.zone];
    up += contact.weight * contact.point.normal;
    foot += contact.weight * contact.point.surface_point;
  }
  if (!(weight > 0.0 && drag_factors > 0.0 && up.squaredNorm() > 0.0)) return Vec3::Zero();
  up.normalize();
  foot /= weight;
  const auto along = [&](const Vec3& at) {
    const Vec3 velocity = motion.velocity_at(at);
    return Vec3(velocity - velocity.dot(up) * up);
  };
  const Vec3 slip = along(foot);
  const double speed = slip.norm();
  if (!(speed > 0.0)) return Vec3::Zero();
  const Pose& pose = motion.block.world_from_body;
  const Quat into_body = pose.rotation.conjugate();
  const EmbeddedFrontalArea front =
      embedded_frontal_area(block_.features, block_.radius, into_body * (foot - pose.translation),
                            into_body * up, into_body * Vec3(slip / speed));
  position_ = pose * front.centre;
  const Vec3 through = along(position_);
  return -(drag_factors / weight) * front.area * through.norm() * through;
}

}  // namespace clast::dem_detail

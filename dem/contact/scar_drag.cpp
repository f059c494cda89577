#include "dem/contact/scar_drag.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace clast::dem_detail {
namespace {

/// Of a ball whose lowest point is `depth` below the plane: a segment of its circle.
EmbeddedFront embedded_ball(const Vec3& centre, double radius, double depth, const Vec3& up) {
  if (!(depth > 0.0)) return {};
  const double half = std::acos(std::max(-1.0, 1.0 - depth / radius));
  const double sine = std::sin(half), share = half - sine * std::cos(half);
  if (!(share > 0.0)) return {};
  const double below = 2.0 / 3.0 * radius * sine * sine * sine / share;
  return {radius * radius * share, centre - below * up};
}

/// The part of a triangle below height 0.
struct Below {
  double area = 0.0;
  Vec3 moment = Vec3::Zero();  ///< area times middle
};
Below part_below(const std::array<Vec3, 3>& corners, const std::array<double, 3>& heights) {
  std::array<Vec3, 4> kept;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (heights[i] < 0.0) kept[count++] = corners[i];
    if ((heights[i] < 0.0) != (heights[j] < 0.0)) {
      const double share = heights[i] / (heights[i] - heights[j]);
      kept[count++] = corners[i] + share * (corners[j] - corners[i]);
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

EmbeddedFront embedded_front(const SurfaceFeatures& block, double radius, const Vec3& ground,
                             const Vec3& up, const Vec3& direction) {
  const auto height = [&](const Vec3& point) { return up.dot(point - ground) - radius; };
  if (block.faces.empty()) {
    const auto lowest =
        std::min_element(block.vertices.begin(), block.vertices.end(),
                         [&](const Vec3& a, const Vec3& b) { return up.dot(a) < up.dot(b); });
    return embedded_ball(*lowest, radius, -height(*lowest), up);
  }
  EmbeddedFront front;
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

Vec3 ScarDrag::update(const std::vector<Contact>& contacts, const PairMotion& motion,
                      double& lost) {
  lost = -0.5 * motion.duration * force_.dot(motion.velocity_from(place_));
  force_ = force_at(contacts, motion);
  lost -= 0.5 * motion.duration * force_.dot(motion.velocity_at(place_));
  return force_;
}

Vec3 ScarDrag::force_at(const std::vector<Contact>& contacts, const PairMotion& motion) {
  // The ground as the mean plane of all contacts.
  double weight = 0.0, strength = 0.0;
  Vec3 up = Vec3::Zero(), foot = Vec3::Zero();
  for (const Contact& contact : contacts) {
    weight += contact.weight;
    strength += contact.weight * strength_[contact.zone];
    up += contact.weight * contact.point.normal;
    foot += contact.weight * contact.point.foot;
  }
  if (!(weight > 0.0 && strength > 0.0 && up.squaredNorm() > 0.0)) return Vec3::Zero();
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
  const EmbeddedFront front =
      embedded_front(block_.features, block_.radius, into_body * (foot - pose.translation),
                     into_body * up, into_body * Vec3(slip / speed));
  place_ = pose * front.centre;
  const Vec3 through = along(place_);
  return -(strength / weight) * front.area * through.norm() * through;
}

}  // namespace clast::dem_detail

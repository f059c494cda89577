#include "dem/detail/deep_contacts.hpp"

#include <algorithm>

namespace clast {
namespace {

/// A contact resolves only those that push elsewhere: normals more than 45 degrees apart.
constexpr double kElsewhereCosine = 0.7071067811865476;

/// True when the point is not inside the solid any more. A body without faces has no inside.
bool free_of(const IndexedSurface& surface, const Vec3& point, double depth) {
  const std::optional<NearestPoint> nearest = surface.nearest(point, depth);
  return !nearest || nearest->distance >= 0.0;
}

}  // namespace

void drop_resolved(std::vector<ContactPoint>& contacts, const IndexedSurface& ground,
                   const IndexedSurface& block, const Pose& ground_from_block) {
  const double reach = ground.radius + block.radius;
  const auto resolved = [&](const ContactPoint& deep) {
    if (deep.kind == ContactKind::kVertexGround || deep.overlap <= reach) return false;
    // Where the core of either is farthest in the other.
    const Vec3 of_ground = deep.foot - ground.radius * deep.normal;
    const Vec3 of_block = of_ground - (deep.overlap - reach) * deep.normal;
    return std::any_of(contacts.begin(), contacts.end(), [&](const ContactPoint& shallow) {
      if (shallow.overlap >= deep.overlap || shallow.normal.dot(deep.normal) > kElsewhereCosine) {
        return false;
      }
      const Vec3 push = shallow.overlap * shallow.normal;
      return free_of(ground, of_block + push, deep.overlap) ||
             (!block.features.faces.empty() &&
              free_of(block, ground_from_block.inverse() * (of_ground - push), deep.overlap));
    });
  };
  if (std::none_of(contacts.begin(), contacts.end(), resolved)) return;
  std::vector<ContactPoint> kept;
  for (const ContactPoint& contact : contacts) {
    if (!resolved(contact)) kept.push_back(contact);
  }
  contacts = std::move(kept);
}

}  // namespace clast

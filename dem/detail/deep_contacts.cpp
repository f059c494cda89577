#include "dem/detail/deep_contacts.hpp"

#include <algorithm>

namespace clast {
namespace {

/// A contact resolves only those that push elsewhere: normals more than 45 degrees apart.
constexpr double kElsewhereCosine = 0.7071067811865476;

}  // namespace

void drop_resolved(std::vector<ContactPoint>& contacts, const IndexedSurface& ground,
                   double reach) {
  const auto resolved = [&](const ContactPoint& deep) {
    if (deep.kind == ContactKind::kVertexGround || deep.overlap <= reach) return false;
    // The point of the block's core that is farthest in.
    const Vec3 inside = deep.foot - (ground.radius + deep.overlap - reach) * deep.normal;
    return std::any_of(contacts.begin(), contacts.end(), [&](const ContactPoint& shallow) {
      if (shallow.overlap >= deep.overlap || shallow.normal.dot(deep.normal) > kElsewhereCosine) {
        return false;
      }
      const Vec3 moved = inside + shallow.overlap * shallow.normal;
      const auto nearest = ground.nearest(moved, deep.overlap);
      return !nearest || nearest->distance >= 0.0;
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

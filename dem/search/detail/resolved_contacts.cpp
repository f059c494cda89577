#include "dem/search/detail/resolved_contacts.hpp"

#include <algorithm>
#include <array>

namespace clast::dem_detail {
namespace {

/// A contact resolves only contacts whose normals differ by more than 45 degrees from its own.
constexpr double kElsewhereCosine = 0.7071067811865476;
/// Its overlap must be below this fraction of theirs, so that both contacts of a wedged block stay.
constexpr double kShallowFraction = 0.5;
/// A contact stays if it is no deeper than this fraction of the block's smallest side. Contacts of
/// resting blocks are less deep; removing and restoring them would keep the blocks moving.
constexpr double kDeepFraction = 0.05;
/// An edge is tested at this fraction of the overlap to either side of the contact. At the contact
/// itself, it just enters the other body, and any push would free it.
constexpr double kAsideFraction = 0.5;
/// A push frees a point that stays inside by less than this fraction of the push.
constexpr double kFreeFraction = 0.1;
/// A feature counts as inside if it is outside by less than this fraction of the overlap.
constexpr double kOutFraction = 0.1;

/// Positions at which a feature is tested: one point, or two of an edge.
using Places = std::array<Vec3, 2>;

Places on_edge(const SurfaceFeatures& surface, std::uint32_t edge, const Vec3& point,
               double aside) {
  const SurfaceEdge& e = surface.edges[edge];
  const Vec3& start = surface.vertices[e.vertices[0]];
  const double at = e.direction.dot(point - start);
  return {start + std::clamp(at - aside, 0.0, e.length) * e.direction,
          start + std::clamp(at + aside, 0.0, e.length) * e.direction};
}

/// True if a push moves all points out of the solid. A body without faces has no inside.
bool free_of(const IndexedSurface& surface, const Places& points, const Vec3& push, double within) {
  return std::all_of(points.begin(), points.end(), [&](const Vec3& position) {
    const std::optional<NearestPoint> nearest = surface.nearest_point(position + push, within);
    return !nearest || nearest->distance >= -kFreeFraction * push.norm();
  });
}

/// True if the point is inside the solid or hardly outside. Always true for a body without faces.
bool hardly_out_of(const IndexedSurface& surface, const Vec3& position, double overlap) {
  if (surface.features.faces.empty()) return true;
  const std::optional<NearestPoint> nearest = surface.nearest_point(position, 2.0 * overlap);
  return nearest && nearest->distance <= kOutFraction * overlap;
}

}  // namespace

void remove_resolved_contacts(std::vector<ContactPoint>& contacts, const IndexedSurface& ground,
                              const IndexedSurface& block, const Pose& ground_from_block,
                              double size) {
  const double reach = ground.radius + block.radius;
  const auto resolved = [&](const ContactPoint& deep) {
    if (deep.kind == ContactKind::kVertexGround || deep.overlap <= reach + kDeepFraction * size) {
      return false;
    }
    // Deepest point of each core in the other body, each in its own frame.
    const Pose block_from_ground = ground_from_block.inverse();
    const Vec3 of_ground = deep.surface_point - ground.radius * deep.normal;
    const Vec3 of_ground_in_block = block_from_ground * of_ground;
    const Vec3 of_block = block_from_ground * (of_ground - (deep.overlap - reach) * deep.normal);
    // Behind an edge or face of a thin or hollow body there is air again. Features that have passed
    // each other there do not touch.
    if (!hardly_out_of(ground, ground_from_block * of_block, deep.overlap) ||
        !hardly_out_of(block, of_ground_in_block, deep.overlap)) {
      return true;
    }
    Places ground_places{of_ground, of_ground}, block_places{of_block, of_block};
    if (deep.kind == ContactKind::kEdgeEdge) {
      const double aside = kAsideFraction * deep.overlap;
      ground_places = on_edge(ground.features, deep.ground_feature, of_ground, aside);
      block_places = on_edge(block.features, deep.block_feature, of_block, aside);
    }
    const auto frees = [&](const ContactPoint& shallow) {
      if (shallow.overlap >= kShallowFraction * deep.overlap ||
          shallow.normal.dot(deep.normal) > kElsewhereCosine) {
        return false;
      }
      const Vec3 push = shallow.overlap * shallow.normal;
      const Places placed{ground_from_block * block_places[0], ground_from_block * block_places[1]};
      if (free_of(ground, placed, push, deep.overlap)) return true;
      const Places in_block{block_from_ground * ground_places[0],
                            block_from_ground * ground_places[1]};
      return !block.features.faces.empty() &&
             free_of(block, in_block, block_from_ground.rotation * -push, deep.overlap);
    };
    return std::any_of(contacts.begin(), contacts.end(), frees);
  };
  if (std::none_of(contacts.begin(), contacts.end(), resolved)) return;
  std::vector<ContactPoint> kept;
  for (const ContactPoint& contact : contacts) {
    if (!resolved(contact)) kept.push_back(contact);
  }
  contacts = std::move(kept);
}

}  // namespace clast::dem_detail

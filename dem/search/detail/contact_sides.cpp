// Contacts of block edges and faces: listing and testing of candidate pairs.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "dem/search/terrain_narrow_phase.hpp"
#include "dem/surface/trim.hpp"

namespace clast::dem_detail {
namespace {

/// Distance up to which pairs are listed, in list margins. Ground features so near get a list.
constexpr double kPairMargins = 1.0;
/// A plane at a ground edge faces out of the ground if the cosines of its angles to the normals of
/// both faces exceed this. All contact normals of the edge then point to the outer side of the
/// plane, although `normal_arc_slack` extends them by up to 4.3 degrees beyond those of the faces.
constexpr double kOutwardCosine = 0.1;

}  // namespace

void TerrainNarrowPhase::update_sides(std::uint32_t p, const AccumulatedDisplacement& ahead,
                                      FoundContacts& found) {
  NearPart& part = *part_states_[p].near;
  const AccumulatedDisplacement then = part.displacement + ahead;
  if (part.all_features.is_expired(then)) {
    for (GroundFeature& feature : part.features) {
      if (feature.separation_bound.is_expired(then)) update_feature(p, feature);
    }
    EarliestBoundExpiry first(part.displacement);
    for (const GroundFeature& feature : part.features) first.include(feature.separation_bound);
    part.all_features = first.separation_bound();
    shrink_capacity(part.pairs);
    part.all_pairs = {};
  }
  if (!part.all_pairs.is_expired(then) &&
      accumulated_displacement_ < part.pairs_contact_free_until) {
    return;
  }
  part.pairs_contact_free_until = 1e300;
  EarliestBoundExpiry first(part.displacement);
  for (FeaturePair& pair : part.pairs) {
    if (!pair.separation_bound.is_expired(then)) {
      first.include(pair.separation_bound);
      continue;
    }
    if (!(accumulated_displacement_ < pair.contact_free_until)) {
      update_pair(part, pair, found);
      if (!pair.separation_bound.is_expired(part.displacement) ||
          !(accumulated_displacement_ < pair.contact_free_until)) {
        first.include(pair.separation_bound);
        continue;
      }
    }
    part.pairs_contact_free_until =
        std::min(part.pairs_contact_free_until, pair.contact_free_until);
  }
  part.all_pairs = first.separation_bound();
}

double TerrainNarrowPhase::contact_distance_across(const SurfaceEdge& ground_edge,
                                                   const Vec3& away) const {
  if (ground_edge.faces[1] == kNoFeature) return contact_distance();
  const double least_squared = kOutwardCosine * kOutwardCosine * away.squaredNorm();
  for (const std::uint32_t face : ground_edge.faces) {
    const double along = away.dot(ground_.features.faces[face].normal);
    if (!(along > 0.0 && along * along > least_squared)) return contact_distance();
  }
  return reach_;
}

void TerrainNarrowPhase::update_feature(std::uint32_t p, GroundFeature& feature) {
  NearPart& part = *part_states_[p].near;
  const BlockPart& of_block = parts_.parts[p];
  const SurfaceFeatures& ground = ground_.features;
  const std::uint32_t index = feature.index;
  std::erase_if(part.pairs, [&](const FeaturePair& pair) {
    return pair.ground_feature == index &&
           (pair.kind != ContactKind::kEdgeEdge) == feature.is_vertex;
  });
  const Segment on_ground = feature.is_vertex ? Segment{ground.vertices[index], Vec3::UnitX(), 0.0}
                                              : ground.segment(ground.edges[index]);
  const auto away_from = [&](const Vec3& point) -> Vec3 {
    return point - on_ground.nearest_point(point);
  };
  const auto contact_distance_along = [&](const Vec3& away) {
    return feature.is_vertex ? contact_distance()
                             : contact_distance_across(ground.edges[index], away);
  };
  const Vec3 away = away_from(part.centre);
  const double distance = away.norm();
  const double clearance = distance - of_block.radius - contact_distance_along(away);
  if (clearance > kPairMargins * margin_) {
    feature.separation_bound = separation_bound(part, away / distance, clearance, 1e300);
    return;
  }
  double others = 1e300;
  for (std::uint32_t s = of_block.first_side; s < of_block.end_side; ++s) {
    const BlockSide& side = parts_.sides[s];
    if (feature.is_vertex ? !side.is_face && !(reach_ > 0.0) : side.is_face) continue;
    const Vec3 away_from_side = away_from(in_ground_frame(side.centre));
    const double squared = away_from_side.squaredNorm();
    double touching = side.radius + contact_distance();
    if (const double near = kPairMargins * margin_ + touching; squared < near * near) {
      touching = side.radius + contact_distance_along(away_from_side);
    }
    const double listed = kPairMargins * margin_ + touching;
    if (squared < listed * listed) {
      const ContactKind kind = !feature.is_vertex ? ContactKind::kEdgeEdge
                               : side.is_face     ? ContactKind::kFaceVertex
                                                  : ContactKind::kEdgeVertex;
      part.pairs.push_back(
          {.kind = kind, .side = s, .ground_feature = index, .separation_bound = {}});
    } else if (const double nearer = others + touching; squared < nearer * nearer) {
      others = std::sqrt(squared) - touching;
    }
  }
  feature.separation_bound = separation_bound(part, part.axis, others, others);
}

void TerrainNarrowPhase::update_pair(const NearPart& part, FeaturePair& pair,
                                     FoundContacts& found) {
  const std::uint32_t of_block = parts_.sides[pair.side].feature;
  std::optional<ContactPoint> contact;
  const FeatureSeparation tested =
      tests_.test_pair(pair.kind, of_block, pair.ground_feature, contact);
  pair.contact_free_until = -1.0;
  if (contact) {
    pair.separation_bound = {};
    found.side_contacts.push_back({pair.side, *contact});
    return;
  }
  const double distance = tested.separation.norm();
  const double touching =
      pair.kind == ContactKind::kEdgeEdge
          ? contact_distance_across(ground_.features.edges[pair.ground_feature], tested.separation)
          : contact_distance();
  pair.separation_bound =
      separation_bound(part, tested.separation / distance, distance - touching, 1e300);
  pair.contact_free_until =
      accumulated_displacement_ + accumulated_per_displacement_ * tested.contact_free_displacement;
}

void TerrainNarrowPhase::add_side_contacts(FoundContacts& found) {
  std::sort(found.side_contacts.begin(), found.side_contacts.end(),
            [](const SideContact& a, const SideContact& b) {
              return std::tuple(a.side, a.point.kind, a.point.ground_feature) <
                     std::tuple(b.side, b.point.kind, b.point.ground_feature);
            });
  for (const SideContact& contact : found.side_contacts)
    add_unique_contact(found.contacts, contact.point);
  found.side_contacts.clear();
}

}  // namespace clast::dem_detail

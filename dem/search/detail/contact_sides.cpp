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
  if (part.all_pairs.is_expired(then)) {
    bool expired = false;
    for (FeaturePair& pair : part.pairs) {
      if (!pair.separation_bound.is_expired(then)) continue;
      update_pair(part, pair, found);
      expired = expired || pair.separation_bound.is_expired(part.displacement);
    }
    EarliestBoundExpiry first(part.displacement);
    if (!expired) {
      for (const FeaturePair& pair : part.pairs) first.include(pair.separation_bound);
    }
    part.all_pairs = expired ? SeparationBound() : first.separation_bound();
  }
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
  const Vec3 away = away_from(part.centre);
  const double distance = away.norm();
  const double clearance = distance - of_block.radius - contact_distance();
  if (clearance > kPairMargins * margin_) {
    feature.separation_bound = separation_bound(part, away / distance, clearance, 1e300);
    return;
  }
  double others = 1e300;
  for (std::uint32_t s = of_block.first_side; s < of_block.end_side; ++s) {
    const BlockSide& side = parts_.sides[s];
    if (feature.is_vertex ? !side.is_face && !(reach_ > 0.0) : side.is_face) continue;
    const double listed = kPairMargins * margin_ + side.radius + contact_distance();
    const double squared = away_from(in_ground_frame(side.centre)).squaredNorm();
    if (squared < listed * listed) {
      const ContactKind kind = !feature.is_vertex ? ContactKind::kEdgeEdge
                               : side.is_face     ? ContactKind::kFaceVertex
                                                  : ContactKind::kEdgeVertex;
      part.pairs.push_back(
          {.kind = kind, .side = s, .ground_feature = index, .separation_bound = {}});
    } else {
      others = std::min(others, std::sqrt(squared) - side.radius - contact_distance());
    }
  }
  feature.separation_bound = separation_bound(part, part.axis, others, others);
}

void TerrainNarrowPhase::update_pair(const NearPart& part, FeaturePair& pair,
                                     FoundContacts& found) {
  const std::uint32_t of_block = parts_.sides[pair.side].feature;
  std::optional<ContactPoint> contact;
  const Vec3 between =
      tests_.test_pair(pair.kind, of_block, pair.ground_feature, contact).separation;
  if (contact) {
    pair.separation_bound = {};
    found.side_contacts.push_back({pair.side, *contact});
    return;
  }
  const double distance = between.norm();
  pair.separation_bound =
      separation_bound(part, between / distance, distance - contact_distance(), 1e300);
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

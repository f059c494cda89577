// Contacts of block edges and faces: which pairs may touch soon, and those that do.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "dem/search/contact_search.hpp"
#include "dem/surface/trim.hpp"

namespace clast::dem_detail {
namespace {

/// Pairs are listed when they are this many margins from touching, in groups by feature of the
/// ground once that is so near to the part.
constexpr double kPairMargins = 1.0;

}  // namespace

void ContactSearch::update_sides(std::uint32_t p, const Way& ahead, Found& found) {
  NearPart& part = *part_states_[p].near;
  const Way then = part.way + ahead;
  if (part.all_features.due(then)) {
    for (GroundFeature& feature : part.features) {
      if (feature.asleep.due(then)) update_feature(p, feature);
    }
    FirstDue first(part.way);
    for (const GroundFeature& feature : part.features) first.include(feature.asleep);
    part.all_features = first.asleep();
    trim(part.pairs);
    part.all_pairs = {};
  }
  if (part.all_pairs.due(then)) {
    bool due = false;
    for (FeaturePair& pair : part.pairs) {
      if (!pair.asleep.due(then)) continue;
      update_pair(part, pair, found);
      due = due || pair.asleep.due(part.way);
    }
    FirstDue first(part.way);
    if (!due) {
      for (const FeaturePair& pair : part.pairs) first.include(pair.asleep);
    }
    part.all_pairs = due ? Asleep() : first.asleep();
  }
}

void ContactSearch::update_feature(std::uint32_t p, GroundFeature& feature) {
  NearPart& part = *part_states_[p].near;
  const BlockPart& of_block = parts_.parts[p];
  const SurfaceFeatures& ground = ground_.features;
  const std::uint32_t number = feature.number;
  std::erase_if(part.pairs, [&](const FeaturePair& pair) {
    return pair.ground_feature == number &&
           (pair.kind != ContactKind::kEdgeEdge) == feature.is_corner;
  });
  const Segment on_ground = feature.is_corner ? Segment{ground.vertices[number], Vec3::UnitX(), 0.0}
                                              : ground.segment(ground.edges[number]);
  const auto away_from = [&](const Vec3& point) -> Vec3 {
    return point - on_ground.nearest(point);
  };
  const Vec3 away = away_from(part.centre);
  const double distance = away.norm();
  const double apart = distance - of_block.radius - touching_distance();
  if (apart > kPairMargins * margin_) {
    feature.asleep = asleep(part, away / distance, apart, 1e300);
    return;
  }
  double others = 1e300;
  for (std::uint32_t s = of_block.first_side; s < of_block.end_side; ++s) {
    const BlockSide& side = parts_.sides[s];
    if (feature.is_corner ? !side.is_face && !(reach_ > 0.0) : side.is_face) continue;
    const double listed = kPairMargins * margin_ + side.radius + touching_distance();
    const double squared = away_from(placed(side.middle)).squaredNorm();
    if (squared < listed * listed) {
      const ContactKind kind = !feature.is_corner ? ContactKind::kEdgeEdge
                               : side.is_face     ? ContactKind::kFaceVertex
                                                  : ContactKind::kEdgeVertex;
      part.pairs.push_back({.kind = kind, .side = s, .ground_feature = number, .asleep = {}});
    } else {
      others = std::min(others, std::sqrt(squared) - side.radius - touching_distance());
    }
  }
  feature.asleep = asleep(part, part.axis, others, others);
}

void ContactSearch::update_pair(const NearPart& part, FeaturePair& pair, Found& found) {
  const std::uint32_t of_block = parts_.sides[pair.side].feature;
  std::optional<ContactPoint> contact;
  const Vec3 between = tests_.side(pair.kind, of_block, pair.ground_feature, contact).between;
  if (contact) {
    pair.asleep = {};
    found.of_sides.push_back({pair.side, *contact});
    return;
  }
  const double distance = between.norm();
  pair.asleep = asleep(part, between / distance, distance - touching_distance(), 1e300);
}

void ContactSearch::add_side_contacts(Found& found) {
  std::sort(found.of_sides.begin(), found.of_sides.end(),
            [](const SideContact& a, const SideContact& b) {
              return std::tuple(a.side, a.point.kind, a.point.ground_feature) <
                     std::tuple(b.side, b.point.kind, b.point.ground_feature);
            });
  for (const SideContact& contact : found.of_sides) add_once(found.contacts, contact.point);
  found.of_sides.clear();
}

}  // namespace clast::dem_detail

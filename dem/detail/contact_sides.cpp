// Contacts of block edges and faces: which pairs may touch soon, and those that do.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "dem/detail/contact_search.hpp"
#include "dem/detail/segment_distance.hpp"

namespace clast::dem_detail {
namespace {

/// A turn can make edges and faces touch that are deeper than anything that touches already: by
/// this share of that depth, and this many margins.
constexpr double kDeeperShare = 0.5, kDeeperMargins = 0.25;
/// What is allowed for is this much deeper, and given up again when it is this much too deep.
constexpr double kAllowedShare = 1.5, kTooDeepShare = 4.0;
/// Pairs are listed when they are this many margins from touching, in groups by feature of the
/// ground once that is so near to the part.
constexpr double kPairMargins = 1.0;

/// The point of a segment nearest to another point.
Vec3 nearest_on(const LocalGround::Edge& edge, const Vec3& point) {
  const double along = std::clamp(edge.direction.dot(point - edge.start), 0.0, edge.length);
  return edge.start + along * edge.direction;
}

}  // namespace

bool ContactSearch::meets_edge(std::uint32_t edge, const Vec3& normal) const {
  return in_arc(block_, block_.edges[edge], -(rotation_.transpose() * normal));
}

bool ContactSearch::edges_carry(const SurfaceEdge& of_ground, const SurfaceEdge& of_block,
                                const Vec3& normal) const {
  const Vec3 in_body = -(rotation_.transpose() * normal);
  return near_arc(ground_.features, of_ground, normal) && near_arc(block_, of_block, in_body);
}

bool ContactSearch::allow_depth() {
  const double needed =
      deepest_ > 0.0 ? (1.0 + kDeeperShare) * deepest_ + kDeeperMargins * margin_ : 0.0;
  const bool deeper = needed > allowed_depth_;
  if (deeper || kTooDeepShare * needed < allowed_depth_) allowed_depth_ = kAllowedShare * needed;
  return deeper;
}

void ContactSearch::update_sides(std::uint32_t p, const Way& ahead) {
  PartState& part = part_states_[p];
  const Way then = part.way + ahead;
  if (part.all_features.due(then)) {
    for (GroundFeature& feature : part.features) {
      if (feature.asleep.due(then)) update_feature(p, feature);
    }
    FirstDue first(part.way);
    for (const GroundFeature& feature : part.features) first.include(feature.asleep);
    part.all_features = first.asleep();
    part.all_pairs = {};
  }
  if (part.all_pairs.due(then)) {
    bool due = false;
    for (FeaturePair& pair : part.pairs) {
      if (!pair.asleep.due(then)) continue;
      update_pair(part, pair);
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
  PartState& part = part_states_[p];
  const BlockPart& of_block = parts_.parts[p];
  const LocalGround& ground = part.ground;
  const std::uint32_t number =
      feature.is_corner ? ground.corners[feature.entry].vertex : ground.edges[feature.entry].edge;
  std::erase_if(part.pairs, [&](const FeaturePair& pair) {
    return pair.ground_feature == number &&
           (pair.kind != ContactKind::kEdgeEdge) == feature.is_corner;
  });
  const auto away_from = [&](const Vec3& point) -> Vec3 {
    return point - (feature.is_corner ? ground.corners[feature.entry].point
                                      : nearest_on(ground.edges[feature.entry], point));
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

void ContactSearch::sleep(const PartState& part, FeaturePair& pair, const Vec3& between) const {
  const double distance = between.norm();
  pair.asleep = asleep(part, between / distance, distance - touching_distance(), 1e300);
}

void ContactSearch::update_pair(const PartState& part, FeaturePair& pair) {
  switch (pair.kind) {
    case ContactKind::kEdgeEdge:
      update_edges(part, pair);
      break;
    case ContactKind::kEdgeVertex:
      update_edge_vertex(part, pair);
      break;
    default:
      update_face_vertex(part, pair);
  }
}

void ContactSearch::update_edges(const PartState& part, FeaturePair& pair) {
  const std::uint32_t block_edge = parts_.sides[pair.side].feature;
  const SurfaceEdge& edge = block_.edges[block_edge];
  const SurfaceEdge& other = ground_.features.edges[pair.ground_feature];
  const Vec3 along = rotation_ * edge.direction;
  const Vec3 start = placed(block_.vertices[edge.vertices[0]]);
  const Vec3& base = ground_.features.vertices[other.vertices[0]];
  const ClosestOnSegments closest =
      closest_on_segments(start, along, edge.length, base, other.direction, other.length);
  sleep(part, pair, closest.between);
  if (!closest.crossing) return;
  Vec3 normal = along.cross(other.direction);
  normal *= (normal.dot(ground_.features.edge_normal(other)) >= 0.0 ? 1.0 : -1.0) / normal.norm();
  const double gap = normal.dot(start - base);
  if (gap >= reach_ || gap < -depth_limit_) return;
  if (!edges_carry(other, edge, normal)) return;
  ContactPoint contact;
  contact.kind = ContactKind::kEdgeEdge;
  contact.block_feature = block_edge;
  contact.ground_feature = pair.ground_feature;
  contact.ground_face = other.faces[0];
  contact.normal = normal;
  contact.overlap = reach_ - gap;
  contact.foot = base + closest.second * other.direction + ground_.radius * normal;
  touch(pair, contact);
}

void ContactSearch::update_edge_vertex(const PartState& part, FeaturePair& pair) {
  const std::uint32_t block_edge = parts_.sides[pair.side].feature;
  const SurfaceEdge& edge = block_.edges[block_edge];
  const Vec3& corner = ground_.features.vertices[pair.ground_feature];
  const Vec3 start = placed(block_.vertices[edge.vertices[0]]);
  const Vec3 along = rotation_ * edge.direction;
  const double s = along.dot(corner - start);
  const Vec3 out = start + std::clamp(s, 0.0, edge.length) * along - corner;
  const double distance = out.norm();
  sleep(part, pair, out);
  if (distance >= reach_ || s <= 0.0 || s >= edge.length || !(distance > 0.0)) return;
  const Vec3 normal = out / distance;
  if (meets_edge(block_edge, normal) && in_cone(ground_.features, pair.ground_feature, normal)) {
    touch_corner(pair, normal, distance);
  }
}

void ContactSearch::update_face_vertex(const PartState& part, FeaturePair& pair) {
  const std::uint32_t block_face = parts_.sides[pair.side].feature;
  const SurfaceFace& face = block_.faces[block_face];
  const Vec3& corner = ground_.features.vertices[pair.ground_feature];
  const Vec3 in_body = rotation_.transpose() * (corner - position_);
  if (depth_in_face(block_, face, in_body) < 0.0) {
    return sleep(part, pair,
                 rotation_ * (in_body - nearest_on_face(block_, block_face, in_body).point));
  }
  const double height = face.normal.dot(in_body - block_.vertices[face.vertices[0]]);
  sleep(part, pair, height * (rotation_ * face.normal));
  if (height >= reach_ || height < -depth_limit_) return;
  const Vec3 normal = -(rotation_ * face.normal);
  if (near_cone(ground_.features, pair.ground_feature, normal)) {
    touch_corner(pair, normal, height);
  }
}

void ContactSearch::touch_corner(FeaturePair& pair, const Vec3& normal, double distance) {
  ContactPoint contact;
  contact.kind = pair.kind;
  contact.block_feature = parts_.sides[pair.side].feature;
  contact.ground_feature = pair.ground_feature;
  contact.ground_face = ground_.face_of_vertex[pair.ground_feature];
  contact.normal = normal;
  contact.overlap = reach_ - distance;
  contact.foot = ground_.features.vertices[pair.ground_feature] + ground_.radius * normal;
  touch(pair, contact);
}

void ContactSearch::touch(FeaturePair& pair, const ContactPoint& contact) {
  pair.asleep = {};
  side_contacts_.push_back({pair.side, contact});
}

void ContactSearch::add_side_contacts() {
  std::sort(side_contacts_.begin(), side_contacts_.end(),
            [](const SideContact& a, const SideContact& b) {
              return std::tuple(a.side, a.point.kind, a.point.ground_feature) <
                     std::tuple(b.side, b.point.kind, b.point.ground_feature);
            });
  for (const SideContact& contact : side_contacts_) add(contact.point);
  side_contacts_.clear();
}

}  // namespace clast::dem_detail

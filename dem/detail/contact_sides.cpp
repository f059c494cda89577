// Contacts of block edges and faces: which pairs may touch soon, and those that do.
#include <algorithm>
#include <cmath>

#include "dem/detail/contact_search.hpp"
#include "dem/detail/segment_distance.hpp"

namespace clast::dem_detail {
namespace {

/// A turn can make edges and faces touch that are deeper than anything that touches already: by
/// this share of that depth, and this many margins.
constexpr double kDeeperShare = 0.5, kDeeperMargins = 0.25;
/// A list of pairs is kept while this share of the movement it allows is left.
constexpr double kWorthKeeping = 0.3;
/// Sides whose states are fetched ahead, and of these the nearer ones whose pairs are: about what
/// the processor can fetch from memory at a time.
constexpr std::size_t kStatesAhead = 8, kPairsAhead = 4;

}  // namespace

bool ContactSearch::meets_edge(std::uint32_t edge, const Vec3& normal) const {
  return in_arc(block_, block_.edges[edge], -(rotation_.transpose() * normal));
}

bool ContactSearch::edges_carry(const SurfaceEdge& of_ground, const SurfaceEdge& of_block,
                                const Vec3& normal) const {
  const Vec3 in_body = -(rotation_.transpose() * normal);
  return near_arc(ground_.features, of_ground, normal) && near_arc(block_, of_block, in_body);
}

void ContactSearch::list_due_sides() {
  due_sides_.clear();
  for (const std::uint32_t s : awake_sides_) due_sides_.add_if(side_due_[s] <= moved_, s);
  for (std::size_t i = 0; i < std::min(kStatesAhead, due_sides_.size()); ++i) {
    __builtin_prefetch(&side_states_[due_sides_[i]]);
  }
}

void ContactSearch::update_due_sides(double within) {
  // A pile is larger than the caches: the next sides are fetched while this one is looked at.
  const std::size_t count = due_sides_.size();
  for (std::size_t i = 0; i < std::min(kPairsAhead, count); ++i) {
    __builtin_prefetch(side_states_[due_sides_[i]].awake.data());
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (i + kStatesAhead < count) __builtin_prefetch(&side_states_[due_sides_[i + kStatesAhead]]);
    if (i + kPairsAhead < count) {
      __builtin_prefetch(side_states_[due_sides_[i + kPairsAhead]].awake.data());
    }
    update_side(due_sides_[i], moved_, within);
  }
}

void ContactSearch::update_side(std::uint32_t s, double until, double within) {
  SideState& state = side_states_[s];
  if (std::min(state.list_until, state.others_clear_until) <= until && !list_holds(s, until)) {
    list_pairs(s, within);
  }
  if (state.sleepers_due <= until) list_awake_pairs(s, std::max(until, moved_ + list_ahead()));
  double due = std::min(state.list_until, state.sleepers_due);
  double clear_until = std::min(state.others_clear_until, state.sleepers_clear_until);
  for (FeaturePair& pair : state.awake) {
    if (pair.due <= until) update_pair(parts_.sides[s].feature, pair);
    due = std::min(due, pair.due);
    clear_until = std::min(clear_until, pair.clear_until);
  }
  side_due_[s] = due;
  state.clear_until = clear_until;
}

void ContactSearch::list_awake_pairs(std::uint32_t s, double horizon) {
  SideState& state = side_states_[s];
  std::vector<FeaturePair>& pairs = side_lists_[s].pairs;
  auto place = pairs.begin();
  for (const FeaturePair& awake : state.awake) {
    while (!place->same_features(awake)) ++place;
    *place = awake;
  }
  state.awake.clear();
  state.sleepers_due = state.sleepers_clear_until = 1e300;
  for (const FeaturePair& pair : pairs) {
    if (pair.due <= horizon) {
      state.awake.push_back(pair);
    } else {
      state.sleepers_due = std::min(state.sleepers_due, pair.due);
      state.sleepers_clear_until = std::min(state.sleepers_clear_until, pair.clear_until);
    }
  }
}

bool ContactSearch::list_holds(std::uint32_t s, double until) {
  const BlockSide& side = parts_.sides[s];
  const SideList& list = side_lists_[s];
  const double used =
      (placed(side.middle) - list.listed).norm() + side.radius * (turned_ - list.listed_turned);
  const double left = list.list_holds - used;
  if (!(left > std::max(until - moved_, kWorthKeeping * list.list_holds))) return false;
  SideState& state = side_states_[s];
  state.list_until = moved_ + left;
  state.others_clear_until = moved_ + (list.others_clear - used);
  return true;
}

void ContactSearch::list_pairs(std::uint32_t s, double within) {
  const BlockSide& side = parts_.sides[s];
  SideState& state = side_states_[s];
  SideList& list = side_lists_[s];
  const LocalGround& ground = part_states_[list.part].ground;
  const Vec3 middle = placed(side.middle);
  list.pairs.clear();
  state.awake.clear();
  state.sleepers_due = -1.0;
  const double complete = completeness(part_states_[list.part]);
  const double by_plane = std::min(ground.plane.clearance(middle) - side.radius, complete);
  const auto hold = [&](double list_holds, double others_clear) {
    list.listed = middle;
    list.listed_turned = turned_;
    list.list_holds = list_holds;
    list.others_clear = others_clear;
    state.list_until = moved_ + list_holds;
    state.others_clear_until = moved_ + others_clear;
  };
  if (by_plane > within) return hold(by_plane - reach_, by_plane - reach_);
  const double listed = within + side.radius;
  double others = complete + side.radius;
  const auto consider = [&](ContactKind kind, std::uint32_t feature, double squared_distance) {
    if (squared_distance < listed * listed) {
      list.pairs.push_back({kind, feature, moved_, moved_});
    } else if (squared_distance < others * others) {
      others = std::sqrt(squared_distance);
    }
  };
  if (!side.is_face) {
    for (const LocalGround::Edge& edge : ground.edges) {
      const Vec3 out = middle - edge.start;
      const double along = std::clamp(edge.direction.dot(out), 0.0, edge.length);
      consider(ContactKind::kEdgeEdge, edge.edge, (out - along * edge.direction).squaredNorm());
    }
  }
  if (side.is_face || reach_ > 0.0) {
    const ContactKind kind = side.is_face ? ContactKind::kFaceVertex : ContactKind::kEdgeVertex;
    for (const LocalGround::Corner& corner : ground.corners) {
      consider(kind, corner.vertex, (middle - corner.point).squaredNorm());
    }
  }
  hold(sleep_distance(others - side.radius), others - side.radius - reach_);
}

double ContactSearch::deepest_pair() const {
  return deepest_ > 0.0 ? (1.0 + kDeeperShare) * deepest_ + kDeeperMargins * margin_ : 0.0;
}

double ContactSearch::sleep_distance(double apart) const {
  // Features that have passed each other inside the ground touch as deep as the block has sunk, so
  // they must be checked again when the one distance reaches the other.
  return std::min(apart - reach_, 0.5 * (apart - deepest_pair()));
}

void ContactSearch::sleep(FeaturePair& pair, double apart) const {
  pair.clear_until = moved_ + (apart - reach_);
  pair.due = moved_ + sleep_distance(apart);
}

void ContactSearch::update_pair(std::uint32_t block_feature, FeaturePair& pair) {
  switch (pair.kind) {
    case ContactKind::kEdgeEdge:
      update_edges(block_feature, pair);
      break;
    case ContactKind::kEdgeVertex:
      update_edge_vertex(block_feature, pair);
      break;
    default:
      update_face_vertex(block_feature, pair);
  }
}

void ContactSearch::update_edges(std::uint32_t block_edge, FeaturePair& pair) {
  const SurfaceEdge& edge = block_.edges[block_edge];
  const SurfaceEdge& other = ground_.features.edges[pair.ground_feature];
  const Vec3 along = rotation_ * edge.direction;
  const Vec3 start = placed(block_.vertices[edge.vertices[0]]);
  const Vec3& base = ground_.features.vertices[other.vertices[0]];
  const ClosestOnSegments closest =
      closest_on_segments(start, along, edge.length, base, other.direction, other.length);
  sleep(pair, closest.between.norm());
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

void ContactSearch::update_edge_vertex(std::uint32_t block_edge, FeaturePair& pair) {
  const SurfaceEdge& edge = block_.edges[block_edge];
  const Vec3& corner = ground_.features.vertices[pair.ground_feature];
  const Vec3 start = placed(block_.vertices[edge.vertices[0]]);
  const Vec3 along = rotation_ * edge.direction;
  const double s = along.dot(corner - start);
  const Vec3 out = start + std::clamp(s, 0.0, edge.length) * along - corner;
  const double distance = out.norm();
  sleep(pair, distance);
  if (distance >= reach_ || s <= 0.0 || s >= edge.length || !(distance > 0.0)) return;
  const Vec3 normal = out / distance;
  if (meets_edge(block_edge, normal) && in_cone(ground_.features, pair.ground_feature, normal)) {
    touch_corner(block_edge, pair, normal, distance);
  }
}

void ContactSearch::update_face_vertex(std::uint32_t block_face, FeaturePair& pair) {
  const SurfaceFace& face = block_.faces[block_face];
  const Vec3& corner = ground_.features.vertices[pair.ground_feature];
  const Vec3 in_body = rotation_.transpose() * (corner - position_);
  if (depth_in_face(block_, face, in_body) < 0.0) {
    return sleep(pair, std::abs(nearest_on_face(block_, block_face, in_body).distance));
  }
  const double height = face.normal.dot(in_body - block_.vertices[face.vertices[0]]);
  sleep(pair, std::abs(height));
  if (height >= reach_ || height < -depth_limit_) return;
  const Vec3 normal = -(rotation_ * face.normal);
  if (near_cone(ground_.features, pair.ground_feature, normal)) {
    touch_corner(block_face, pair, normal, height);
  }
}

void ContactSearch::touch_corner(std::uint32_t block_feature, FeaturePair& pair, const Vec3& normal,
                                 double distance) {
  ContactPoint contact;
  contact.kind = pair.kind;
  contact.block_feature = block_feature;
  contact.ground_feature = pair.ground_feature;
  contact.ground_face = ground_.face_of_vertex[pair.ground_feature];
  contact.normal = normal;
  contact.overlap = reach_ - distance;
  contact.foot = ground_.features.vertices[pair.ground_feature] + ground_.radius * normal;
  touch(pair, contact);
}

void ContactSearch::touch(FeaturePair& pair, const ContactPoint& contact) {
  pair.due = pair.clear_until = moved_;
  add(contact);
}

}  // namespace clast::dem_detail

// Contacts of block edges and faces: which pairs may touch soon, and those that do.
#include <algorithm>
#include <cmath>

#include "dem/detail/contact_search.hpp"
#include "dem/detail/segment_distance.hpp"

namespace clast {
namespace {

/// Pairs of edges and faces are gathered for this many margins of travel: gathering is dear, a pair
/// that sleeps is cheap.
constexpr double kPairMargins = 2.0;
/// Distances of block vertices older than this many margins are measured anew when edges are
/// paired.
constexpr double kStaleMargins = 3.0;
/// Lines that meet at a smaller angle (its sine) are parallel: the end vertices carry the contact.
constexpr double kParallelSine = 1e-6;

}  // namespace

void ContactSearch::refresh_pairs(double travel) {
  pairs_.clear();
  // Far from the ground no list is needed at all.
  const double look = bounding_radius_ + reach_ + 8.0 * margin_;
  double above = ground_.height_clearance(position_, 2.0 * look);
  if (above < look) {
    const std::optional<NearestPoint> nearest = ground_.nearest(position_, 2.0 * look);
    above = nearest ? nearest->distance : 2.0 * look;
  }
  if (above > bounding_radius_ + reach_ + margin_) {
    pairs_until_ = travel + above - bounding_radius_ - reach_;
    return;
  }
  const double ahead = kPairMargins * margin_;
  pairs_until_ = travel + ahead;

  Bounds box;
  for (const Vec3& vertex : block_.vertices) box.include(position_ + rotation_ * vertex);
  std::vector<std::uint32_t> edges, corners;
  for (const std::uint32_t f : ground_.faces_near(box, reach_ + 2.0 * ahead)) {
    const SurfaceFace& face = ground_.features.faces[f];
    for (int k = 0; k < 3; ++k) {
      const SurfaceEdge& edge = ground_.features.edges[face.edges[k]];
      if (edge.convex()) edges.push_back(face.edges[k]);
      if (ground_.features.pointed[face.vertices[k]]) corners.push_back(face.vertices[k]);
    }
  }
  const auto unique = [](std::vector<std::uint32_t>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  };
  unique(edges);
  unique(corners);
  if (edges.empty() && corners.empty()) return;

  // Lower bounds of how far block vertices are from the ground; what is too vague to rule an edge
  // out is measured anew.
  const double worth_measuring = longest_edge_ + reach_ + 4.0 * margin_;
  std::vector<double> bound(block_.vertices.size());
  for (std::uint32_t v = 0; v < bound.size(); ++v) {
    bound[v] = distances_[v] - (travel - seen_at_[v]);
    if (bound[v] < worth_measuring && travel - seen_at_[v] > kStaleMargins * margin_) {
      const Vec3 centre = placed(v);
      double distance = ground_.height_clearance(centre, worth_measuring);
      if (distance < worth_measuring) {
        const std::optional<NearestPoint> nearest = ground_.nearest(centre, 2.0 * bounding_radius_);
        distance = nearest ? nearest->distance : 2.0 * bounding_radius_;
      }
      bound[v] = distances_[v] = distance;
      seen_at_[v] = travel;
    }
  }
  const double interest = std::max(reach_, deepest_) + 2.0 * ahead;
  // Enclosing balls in the body frame rule most pairs out.
  struct Ball {
    Vec3 centre;
    double radius;
  };
  const auto in_body = [&](const Vec3& p) { return Vec3(rotation_.transpose() * (p - position_)); };
  std::vector<Ball> edge_balls, corner_balls;
  for (const std::uint32_t g : edges) {
    const SurfaceEdge& edge = ground_.features.edges[g];
    const Vec3 middle = 0.5 * (ground_.features.vertices[edge.vertices[0]] +
                               ground_.features.vertices[edge.vertices[1]]);
    edge_balls.push_back({in_body(middle), 0.5 * edge.length});
  }
  for (const std::uint32_t g : corners) {
    corner_balls.push_back({in_body(ground_.features.vertices[g]), 0.0});
  }
  const auto consider = [&](ContactKind kind, std::uint32_t of_block, const Ball& ball,
                            const std::vector<std::uint32_t>& candidates,
                            const std::vector<Ball>& candidate_balls) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double near = interest + ball.radius + candidate_balls[i].radius;
      if ((ball.centre - candidate_balls[i].centre).squaredNorm() > near * near) continue;
      Pair pair{kind, of_block, candidates[i], 0.0};
      const double apart = distance(pair);
      if (apart > interest) continue;
      pair.due = travel + std::max(0.0, apart - std::max(reach_, deepest_ + ahead));
      pairs_.push_back(pair);
    }
  };
  for (std::uint32_t e = 0; e < block_.edges.size(); ++e) {
    const SurfaceEdge& edge = block_.edges[e];
    if (!edge.convex()) continue;
    const auto [a, b] = edge.vertices;
    if (0.5 * (bound[a] + bound[b] - edge.length) > interest) continue;
    const Ball ball{0.5 * (block_.vertices[a] + block_.vertices[b]), 0.5 * edge.length};
    consider(ContactKind::kEdgeEdge, e, ball, edges, edge_balls);
    if (reach_ > 0.0) consider(ContactKind::kEdgeVertex, e, ball, corners, corner_balls);
  }
  for (std::uint32_t f = 0; f < block_.faces.size(); ++f) {
    const auto [a, b, c] = block_.faces[f].vertices;
    const Vec3 middle = (block_.vertices[a] + block_.vertices[b] + block_.vertices[c]) / 3.0;
    const double radius = std::sqrt(std::max({(block_.vertices[a] - middle).squaredNorm(),
                                              (block_.vertices[b] - middle).squaredNorm(),
                                              (block_.vertices[c] - middle).squaredNorm()}));
    // Every point of the face is within `radius` of its middle, and the middle within it of `a`.
    if (std::max({bound[a], bound[b], bound[c]}) - 2.0 * radius > interest) continue;
    consider(ContactKind::kFaceVertex, f, {middle, radius}, corners, corner_balls);
  }
}

double ContactSearch::distance(const Pair& pair) const {
  const SurfaceFeatures& ground = ground_.features;
  if (pair.kind == ContactKind::kFaceVertex) {
    const Vec3 in_body = rotation_.transpose() * (ground.vertices[pair.ground_feature] - position_);
    return std::abs(nearest_on_face(block_, pair.block_feature, in_body).distance);
  }
  const SurfaceEdge& edge = block_.edges[pair.block_feature];
  const Vec3 start = placed(edge.vertices[0]);
  const Vec3 along = rotation_ * edge.direction;
  if (pair.kind == ContactKind::kEdgeVertex) {
    const Vec3& corner = ground.vertices[pair.ground_feature];
    const double s = std::clamp(along.dot(corner - start), 0.0, edge.length);
    return (start + s * along - corner).norm();
  }
  const SurfaceEdge& other = ground.edges[pair.ground_feature];
  return segment_distance(start, along, edge.length, ground.vertices[other.vertices[0]],
                          other.direction, other.length);
}

void ContactSearch::look_at_pair(Pair& pair, double travel) {
  switch (pair.kind) {
    case ContactKind::kEdgeEdge:
      return look_at_edges(pair, travel);
    case ContactKind::kEdgeVertex:
      return look_at_edge_vertex(pair, travel);
    default:
      return look_at_face_vertex(pair, travel);
  }
}

void ContactSearch::look_at_edges(Pair& pair, double travel) {
  const SurfaceEdge& edge = block_.edges[pair.block_feature];
  const SurfaceEdge& other = ground_.features.edges[pair.ground_feature];
  const Vec3 along = rotation_ * edge.direction;
  Vec3 normal = along.cross(other.direction);
  const double sine = normal.norm();
  if (sine < kParallelSine) return;
  normal *= (normal.dot(other.normal) >= 0.0 ? 1.0 : -1.0) / sine;
  const Vec3 start = placed(edge.vertices[0]);
  const Vec3& base = ground_.features.vertices[other.vertices[0]];
  const double gap = normal.dot(start - base);
  if (gap >= reach_) {
    pair.due = travel + gap - reach_;  // the lines are that far apart, so the edges are too
    return;
  }
  if (gap < -depth_limit_) return;
  const ClosestOnLines closest = closest_on_lines(start, along, base, other.direction);
  if (closest.first < 0.0 || closest.first > edge.length || closest.second < 0.0 ||
      closest.second > other.length) {
    return;
  }
  if (!near_arc(other, normal) || !near_arc(edge, -(rotation_.transpose() * normal))) return;
  ContactPoint contact;
  contact.kind = ContactKind::kEdgeEdge;
  contact.block_feature = pair.block_feature;
  contact.ground_feature = pair.ground_feature;
  contact.ground_face = other.faces[0];
  contact.normal = normal;
  contact.overlap = reach_ - gap;
  contact.foot = base + closest.second * other.direction + ground_.radius * normal;
  add(contact);
}

void ContactSearch::look_at_edge_vertex(Pair& pair, double travel) {
  const SurfaceEdge& edge = block_.edges[pair.block_feature];
  const Vec3& corner = ground_.features.vertices[pair.ground_feature];
  const Vec3 start = placed(edge.vertices[0]);
  const Vec3 along = rotation_ * edge.direction;
  const double s = along.dot(corner - start);
  const Vec3 out = start + std::clamp(s, 0.0, edge.length) * along - corner;
  const double distance = out.norm();
  if (distance >= reach_) {
    pair.due = travel + distance - reach_;
    return;
  }
  if (s <= 0.0 || s >= edge.length || !(distance > 0.0)) return;
  const Vec3 normal = out / distance;
  if (meets_edge(edge, normal) && in_cone(ground_.features, pair.ground_feature, normal)) {
    touch_corner(pair, normal, distance);
  }
}

void ContactSearch::look_at_face_vertex(Pair& pair, double travel) {
  const SurfaceFace& face = block_.faces[pair.block_feature];
  const Vec3& corner = ground_.features.vertices[pair.ground_feature];
  const Vec3 in_body = rotation_.transpose() * (corner - position_);
  const double height = face.normal.dot(in_body - block_.vertices[face.vertices[0]]);
  if (height >= reach_) {
    pair.due = travel + height - reach_;
    return;
  }
  if (height < -depth_limit_) return;
  for (int k = 0; k < 3; ++k) {
    if (face.inward[k].dot(in_body - block_.vertices[face.vertices[k]]) < 0.0) return;
  }
  const Vec3 normal = -(rotation_ * face.normal);
  if (near_cone(ground_.features, pair.ground_feature, normal)) touch_corner(pair, normal, height);
}

void ContactSearch::touch_corner(const Pair& pair, const Vec3& normal, double distance) {
  ContactPoint contact;
  contact.kind = pair.kind;
  contact.block_feature = pair.block_feature;
  contact.ground_feature = pair.ground_feature;
  contact.ground_face = ground_.face_of_vertex[pair.ground_feature];
  contact.normal = normal;
  contact.overlap = reach_ - distance;
  contact.foot = ground_.features.vertices[pair.ground_feature] + ground_.radius * normal;
  add(contact);
}

}  // namespace clast

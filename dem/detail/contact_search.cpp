#include "dem/detail/contact_search.hpp"

#include <algorithm>
#include <cmath>

#include "dem/detail/segment_distance.hpp"

namespace clast {
namespace {

/// Candidate lists look ahead this share of the block's smallest side: long enough to be rebuilt
/// rarely, short enough to stay short.
constexpr double kMarginShare = 0.05;
/// Pairs of edges and faces are gathered for this many margins of travel: gathering is dear, a pair
/// that sleeps is cheap.
constexpr double kPairMargins = 2.0;
/// Distances of block vertices older than this many margins are measured anew when edges are
/// paired.
constexpr double kStaleMargins = 3.0;
/// Edge and face contacts deeper than this share of the smallest side are not trusted: beyond the
/// middle of the block the opposite side would be nearer.
constexpr double kDepthShare = 0.5;
/// Slack of direction tests, a sine.
constexpr double kSlack = 1e-9;

}  // namespace

ContactSearch::ContactSearch(const TerrainSurface::Impl& ground, const RigidBody& body)
    : ground_(ground) {
  const TriangleMesh core = core_mesh(body.shape);
  std::vector<std::array<std::uint32_t, 2>> wires;
  if (body.shape.faces.empty()) wires = body.shape.edges;
  block_ = surface_features(core, wires);
  reach_ = body.shape.radius + ground.radius;
  bounding_radius_ = body.bounding_radius() - body.shape.radius;
  const double size = body.smallest_side > 0.0 ? body.smallest_side : 2.0 * body.bounding_radius();
  margin_ = kMarginShare * size;
  depth_limit_ = kDepthShare * size;
  for (const SurfaceEdge& edge : block_.edges) longest_edge_ = std::max(longest_edge_, edge.length);
  const std::size_t count = block_.vertices.size();
  vertices_.resize(count);
  due_.assign(count, -1.0);
  distances_.assign(count, 0.0);
  seen_at_.assign(count, -1e300);
  for (std::uint32_t v = 0; v < count; ++v) {
    if (block_.pointed[v]) pointed_.push_back(v);
  }
}

const std::vector<ContactPoint>& ContactSearch::contacts(const Pose& world_from_body,
                                                         double travel) {
  rotation_ = world_from_body.rotation.toRotationMatrix();
  position_ = world_from_body.translation;
  contacts_.clear();
  if (travel > horizon_) {
    horizon_ = travel + margin_;
    awake_.clear();
    for (const std::uint32_t v : pointed_) {
      if (due_[v] <= horizon_) awake_.push_back(v);
    }
  }
  for (const std::uint32_t v : awake_) {
    if (due_[v] <= travel) look_at_vertex(v, travel);
  }
  for (const ContactPoint& contact : contacts_) deepest_ = std::max(deepest_, contact.overlap);
  if (travel >= pairs_until_) refresh_pairs(travel);
  for (Pair& pair : pairs_) {
    if (pair.due <= travel) look_at_pair(pair, travel);
  }
  deepest_ = 0.0;
  for (const ContactPoint& contact : contacts_) deepest_ = std::max(deepest_, contact.overlap);
  return contacts_;
}

double ContactSearch::safe_travel() const {
  double earliest = std::min(pairs_until_, 1e300);
  for (const std::uint32_t v : pointed_) earliest = std::min(earliest, due_[v]);
  for (const Pair& pair : pairs_) earliest = std::min(earliest, pair.due);
  return earliest;
}

void ContactSearch::add(const ContactPoint& contact) {
  // A point on the border between two faces of one plane, or at the joint of two collinear edges,
  // is found twice but is one contact.
  for (const ContactPoint& known : contacts_) {
    const bool related =
        known.kind == contact.kind && (known.block_feature == contact.block_feature ||
                                       (known.kind != ContactKind::kVertexGround &&
                                        known.ground_feature == contact.ground_feature));
    if (related && known.normal.dot(contact.normal) > 1.0 - 1e-12 &&
        (known.foot - contact.foot).squaredNorm() < 1e-18) {
      return;
    }
  }
  contacts_.push_back(contact);
}

bool ContactSearch::block_cone_holds(std::uint32_t vertex, const Vec3& direction) const {
  const Vec3 in_body = rotation_.transpose() * direction;
  for (const Vec3& ray : block_.rays_of(vertex)) {
    if (ray.dot(in_body) < -kSlack) return false;
  }
  return true;
}

void ContactSearch::look_at_vertex(std::uint32_t vertex, double travel) {
  VertexState& state = vertices_[vertex];
  const Vec3 centre = world(vertex);
  const auto sleep = [&](double distance) {
    distances_[vertex] = distance;
    seen_at_[vertex] = travel;
    due_[vertex] = travel + (distance - reach_);
  };

  if (travel > state.list_until) {
    double deepest = travel - seen_at_[vertex] - distances_[vertex];
    if (distances_[vertex] > reach_ + margin_ || deepest > margin_) {
      // Not known well enough to gather a short list: measured anew.
      const double look = reach_ + 8.0 * margin_;
      const double above = ground_.height_clearance(centre, look);
      if (above > reach_ + margin_) return sleep(above);
      const double far = look + 4.0 * bounding_radius_;
      const std::optional<NearestPoint> nearest = ground_.nearest(centre, far);
      if (!nearest) return sleep(far);
      if (nearest->distance > reach_ + margin_) return sleep(nearest->distance);
      deepest = -nearest->distance;
    }
    // Until the list runs out the centre moves by at most one margin and sinks by at most one more.
    const double radius = std::max(reach_, std::max(0.0, deepest) + margin_) + margin_;
    Bounds here;
    here.include(centre);
    state.faces = ground_.faces_near(here, radius);
    state.list_until = travel + margin_;
    state.sure_face = kNoFeature;
  }

  if (look_at_sure_face(vertex, centre, travel)) return;
  NearestPoint nearest;
  nearest.distance = 1e300;
  double second = 1e300;  // a lower bound of how far all other faces are
  for (const std::uint32_t f : state.faces) {
    const SurfaceFace& face = ground_.features.faces[f];
    const double height = face.normal.dot(centre - ground_.features.vertices[face.vertices[0]]);
    if (std::abs(height) >= std::abs(nearest.distance)) {
      second = std::min(second, std::abs(height));
      continue;
    }
    const NearestPoint candidate = nearest_on_face(ground_.features, f, centre);
    const bool nearer = std::abs(candidate.distance) < std::abs(nearest.distance);
    second = std::min(second, std::abs(nearer ? nearest.distance : candidate.distance));
    if (nearer) nearest = candidate;
  }
  state.sure_face = nearest.within_face ? nearest.face : kNoFeature;
  state.sure_inside_until =
      std::min(state.list_until, travel + 0.5 * (second - std::abs(nearest.distance)));
  state.sure_outside_until = std::min(state.list_until, travel + second - reach_);
  if (nearest.face == kNoFeature || nearest.distance >= reach_) {
    // Beyond the list's reach nothing is known.
    const double known = nearest.face == kNoFeature ? reach_ + margin_ : nearest.distance;
    return sleep(std::min(known, reach_ + state.list_until - travel));
  }
  sleep(nearest.distance);
  if (nearest.distance >= 0.0) return add_outside_contacts(vertex, centre);
  add_inside_contact(vertex, centre, nearest);
}

bool ContactSearch::look_at_sure_face(std::uint32_t vertex, const Vec3& centre, double travel) {
  VertexState& state = vertices_[vertex];
  if (state.sure_face == kNoFeature) return false;
  const SurfaceFace& face = ground_.features.faces[state.sure_face];
  const double height = face.normal.dot(centre - ground_.features.vertices[face.vertices[0]]);
  if (travel >= (height < 0.0 ? state.sure_inside_until : state.sure_outside_until)) return false;
  distances_[vertex] = height;
  seen_at_[vertex] = travel;
  if (height >= reach_) {
    due_[vertex] = std::min(travel + height - reach_, state.sure_outside_until);
    return true;
  }
  for (int k = 0; k < 3; ++k) {
    if (face.inward[k].dot(centre - ground_.features.vertices[face.vertices[k]]) < 0.0)
      return false;
  }
  due_[vertex] = travel;
  ContactPoint contact;
  contact.block_feature = vertex;
  contact.ground_feature = contact.ground_face = state.sure_face;
  contact.normal = face.normal;
  contact.overlap = reach_ - height;
  contact.foot = centre + (ground_.radius - height) * face.normal;
  contacts_.push_back(contact);
  return true;
}

void ContactSearch::add_inside_contact(std::uint32_t vertex, const Vec3& centre,
                                       const NearestPoint& nearest) {
  ContactPoint contact;
  contact.block_feature = vertex;
  contact.ground_feature = contact.ground_face = nearest.face;
  const double depth = -nearest.distance;
  // On the surface itself, and above a face, the direction to it is its normal.
  contact.normal =
      nearest.within_face || depth < 1e-9 ? nearest.normal : Vec3((nearest.point - centre) / depth);
  contact.overlap = reach_ + depth;
  contact.foot = nearest.point + ground_.radius * contact.normal;
  contacts_.push_back(contact);
}

void ContactSearch::add_outside_contacts(std::uint32_t vertex, const Vec3& centre) {
  const SurfaceFeatures& ground = ground_.features;
  ContactPoint contact;
  contact.block_feature = vertex;
  const auto touch = [&](std::uint32_t face, const Vec3& on_ground, const Vec3& normal,
                         double distance) {
    contact.ground_feature = contact.ground_face = face;
    contact.normal = normal;
    contact.overlap = reach_ - distance;
    contact.foot = on_ground + ground_.radius * normal;
    add(contact);
  };
  for (const std::uint32_t f : vertices_[vertex].faces) {
    const SurfaceFace& face = ground.faces[f];
    const double height = face.normal.dot(centre - ground.vertices[face.vertices[0]]);
    if (height < 0.0 || height >= reach_) continue;
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
      inside = inside && face.inward[k].dot(centre - ground.vertices[face.vertices[k]]) >= 0.0;
    }
    if (inside) {
      touch(f, centre - height * face.normal, face.normal, height);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const SurfaceEdge& edge = ground.edges[face.edges[k]];
      if (edge.faces[0] == f && edge.convex()) {  // each edge once
        const double along = edge.direction.dot(centre - ground.vertices[edge.vertices[0]]);
        if (along >= 0.0 && along <= edge.length) {
          const Vec3 on_edge = ground.vertices[edge.vertices[0]] + along * edge.direction;
          const Vec3 out = centre - on_edge;
          const double distance = out.norm();
          if (distance > 0.0 && distance < reach_) {
            const Vec3 normal = out / distance;
            if (in_arc(edge, normal) && block_cone_holds(vertex, normal)) {
              touch(f, on_edge, normal, distance);
            }
          }
        }
      }
      const std::uint32_t corner = face.vertices[k];
      if (!ground.pointed[corner]) continue;
      const Vec3 out = centre - ground.vertices[corner];
      const double distance = out.norm();
      if (!(distance > 0.0 && distance < reach_)) continue;
      const Vec3 normal = out / distance;
      if (in_cone(ground, corner, normal) && block_cone_holds(vertex, normal)) {
        touch(f, ground.vertices[corner], normal, distance);
      }
    }
  }
}

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
      const Vec3 centre = world(v);
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
  const Vec3 start = world(edge.vertices[0]);
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
  if (sine < 1e-6) return;  // parallel: the end vertices carry the contact
  normal *= (normal.dot(other.normal) >= 0.0 ? 1.0 : -1.0) / sine;
  const Vec3 start = world(edge.vertices[0]);
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
  if (!in_arc(other, normal)) return;
  if (normal.dot(rotation_ * edge.inward[0]) < -kSlack ||
      normal.dot(rotation_ * edge.inward[1]) < -kSlack) {
    return;
  }
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
  const Vec3 start = world(edge.vertices[0]);
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
  if (!in_cone(ground_.features, pair.ground_feature, normal)) return;
  if (normal.dot(rotation_ * edge.inward[0]) < -kSlack ||
      normal.dot(rotation_ * edge.inward[1]) < -kSlack) {
    return;
  }
  ContactPoint contact;
  contact.kind = ContactKind::kEdgeVertex;
  contact.block_feature = pair.block_feature;
  contact.ground_feature = pair.ground_feature;
  contact.ground_face = ground_.face_of_vertex[pair.ground_feature];
  contact.normal = normal;
  contact.overlap = reach_ - distance;
  contact.foot = corner + ground_.radius * normal;
  add(contact);
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
  if (!in_cone(ground_.features, pair.ground_feature, normal)) return;
  ContactPoint contact;
  contact.kind = ContactKind::kFaceVertex;
  contact.block_feature = pair.block_feature;
  contact.ground_feature = pair.ground_feature;
  contact.ground_face = ground_.face_of_vertex[pair.ground_feature];
  contact.normal = normal;
  contact.overlap = reach_ - height;
  contact.foot = corner + ground_.radius * normal;
  add(contact);
}

}  // namespace clast

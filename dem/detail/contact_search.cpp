#include "dem/detail/contact_search.hpp"

#include <algorithm>
#include <cmath>

#include "dem/detail/deep_contacts.hpp"

namespace clast {
namespace {

/// Candidate lists look ahead this share of the block's smallest side: long enough to be rebuilt
/// rarely, short enough to stay short.
constexpr double kMarginShare = 0.05;
/// Edge and face contacts deeper than this share of the smallest side are not trusted: beyond the
/// middle of the block the opposite side would be nearer.
constexpr double kDepthShare = 0.5;

}  // namespace

ContactSearch::ContactSearch(const IndexedSurface& ground, const IndexedSurface& block, double size)
    : ground_(ground),
      surface_(block),
      block_(block.features),
      reach_(block.radius + ground.radius) {
  for (const Vec3& vertex : block_.vertices) {
    bounding_radius_ = std::max(bounding_radius_, vertex.norm());
  }
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

const std::vector<ContactPoint>& ContactSearch::contacts(const Pose& ground_from_body,
                                                         double travel) {
  rotation_ = ground_from_body.rotation.toRotationMatrix();
  position_ = ground_from_body.translation;
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
  drop_resolved(contacts_, ground_, surface_, ground_from_body);
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

bool ContactSearch::meets_vertex(std::uint32_t vertex, const Vec3& normal) const {
  return in_cone(block_, vertex, -(rotation_.transpose() * normal));
}

bool ContactSearch::meets_edge(const SurfaceEdge& edge, const Vec3& normal) const {
  return in_arc(edge, -(rotation_.transpose() * normal));
}

void ContactSearch::look_at_vertex(std::uint32_t vertex, double travel) {
  VertexState& state = vertices_[vertex];
  const Vec3 centre = placed(vertex);
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
  const bool inside = nearest.face != kNoFeature && nearest.distance < 0.0;
  const bool backwards = inside && pushes_backwards(vertex, push_of(nearest, centre));
  state.sure_face = nearest.within_face && !backwards ? nearest.face : kNoFeature;
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
  if (backwards) nearest = nearest_forwards(vertex, centre, nearest);
  add_inside_contact(vertex, centre, nearest);
}

Vec3 ContactSearch::push_of(const NearestPoint& nearest, const Vec3& centre) {
  // On the surface itself, and above a face, the direction to it is its normal.
  return nearest.within_face || nearest.distance > -1e-9
             ? nearest.normal
             : Vec3((nearest.point - centre) / -nearest.distance);
}

bool ContactSearch::pushes_backwards(std::uint32_t vertex, const Vec3& push) const {
  return push.dot(rotation_ * block_.vertex_normals[vertex]) > 0.0;
}

NearestPoint ContactSearch::nearest_forwards(std::uint32_t vertex, const Vec3& centre,
                                             const NearestPoint& nearest) const {
  NearestPoint best = nearest;
  double distance = 1e300;
  for (const std::uint32_t f : vertices_[vertex].faces) {
    const NearestPoint candidate = nearest_on_face(ground_.features, f, centre);
    if (candidate.within_face && candidate.distance < 0.0 && -candidate.distance < distance &&
        !pushes_backwards(vertex, push_of(candidate, centre))) {
      distance = -candidate.distance;
      best = candidate;
    }
  }
  return best;
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
  if (height < 0.0 && pushes_backwards(vertex, face.normal)) return false;
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
  contact.normal = push_of(nearest, centre);
  contact.overlap = reach_ - nearest.distance;
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
            if (in_arc(edge, normal) && meets_vertex(vertex, normal)) {
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
      if (in_cone(ground, corner, normal) && meets_vertex(vertex, normal)) {
        touch(f, ground.vertices[corner], normal, distance);
      }
    }
  }
}

}  // namespace clast

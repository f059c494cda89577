// Contacts of block vertices: when each must be measured, and how it touches.
#include <algorithm>
#include <cmath>

#include "dem/detail/contact_search.hpp"

namespace clast::dem_detail {
namespace {

/// A vertex that may have moved all its distance but really moved less than this share of it needs
/// no new measurement.
constexpr double kLittleMoved = 0.5;
/// And one that is known to be this many margins away needs none either.
constexpr double kEnough = 0.25;
/// Faces up to this many margins behind the nearest are distinguished from it.
constexpr double kDistinctMargins = 4.0;

}  // namespace

bool ContactSearch::meets_vertex(std::uint32_t vertex, const Vec3& normal) const {
  return in_cone(block_, vertex, -(rotation_.transpose() * normal));
}

void ContactSearch::update_vertex(std::uint32_t v, double until) {
  VertexState& state = vertex_states_[v];
  const Vec3 centre = placed(block_.vertices[parts_.vertices[v]]);
  if (update_sure_face(v, centre)) return;
  // Often the last measurement or the plane bounds the gap well enough.
  const PartState& part = part_states_[state.part];
  const double gap = state.distance - reach_;
  const double by_movement = gap - (centre - state.seen).norm();
  const double by_plane =
      std::min(part.ground.plane.clearance(centre), completeness(part)) - reach_;
  const double known = std::max(by_movement, by_plane);
  if (known > std::max(until - moved_, std::min(kEnough * margin_, kLittleMoved * gap))) {
    vertex_due_[v] = moved_ + known;
    return;
  }
  measure_vertex(v, centre);
}

void ContactSearch::measure_vertex(std::uint32_t v, const Vec3& centre) {
  VertexState& state = vertex_states_[v];
  const PartState& part = part_states_[state.part];
  const double complete = completeness(part);
  // Other faces are measured only as far as it matters that they are farther.
  const double beyond = state.distance < reach_ + margin_ ? kDistinctMargins * margin_ : 0.0;
  const LocalGround::Nearest found =
      part.ground.nearest(ground_.features, centre, complete, beyond, state.near_face);
  const NearestPoint& nearest = found.nearest;
  state.near_face = found.entry;
  const double depth = std::abs(nearest.distance);

  state.seen_at = moved_;
  state.seen = centre;
  state.sure_face = kNoFeature;
  // Beyond the list nothing is known, not even the side.
  state.distance = depth < complete ? nearest.distance : complete;
  vertex_due_[v] = moved_ + (state.distance - reach_);
  if (depth >= complete) return;
  const bool backwards =
      nearest.distance < 0.0 && pushes_backwards(parts_.vertices[v], push_of(nearest, centre));
  if (nearest.within_face && !backwards) {
    state.sure_face = nearest.face;
    state.sure_foot_until = moved_;
    state.sure_inside_until = moved_ + 0.5 * (found.second - depth);
    state.sure_outside_until = moved_ + (found.second - reach_);
  }
  if (nearest.distance >= reach_) return;
  if (nearest.distance >= 0.0) return add_outside_contacts(v, centre);
  add_inside_contact(v, centre, backwards ? nearest_forwards(v, centre, nearest) : nearest);
}

Vec3 ContactSearch::push_of(const NearestPoint& nearest, const Vec3& centre) const {
  // On the surface itself, and above a face, the direction to it is its normal. So it is beyond the
  // border of a survey: the way back to the border would lead down where the ground falls to it.
  return nearest.within_face || nearest.distance > -1e-9 || on_border(ground_.features, nearest)
             ? nearest.normal
             : Vec3((nearest.point - centre) / -nearest.distance);
}

bool ContactSearch::pushes_backwards(std::uint32_t vertex, const Vec3& push) const {
  return ground_.of_block && push.dot(rotation_ * block_.vertex_normals[vertex]) > 0.0;
}

NearestPoint ContactSearch::nearest_forwards(std::uint32_t v, const Vec3& centre,
                                             const NearestPoint& nearest) const {
  NearestPoint best = nearest;
  double distance = 1e300;
  for (const LocalGround::Face& face : part_states_[vertex_states_[v].part].ground.faces) {
    const NearestPoint candidate = nearest_on_face(ground_.features, face.face, centre);
    if (candidate.within_face && candidate.distance < 0.0 && -candidate.distance < distance &&
        !pushes_backwards(parts_.vertices[v], push_of(candidate, centre))) {
      distance = -candidate.distance;
      best = candidate;
    }
  }
  return best;
}

bool ContactSearch::update_sure_face(std::uint32_t v, const Vec3& centre) {
  VertexState& state = vertex_states_[v];
  if (state.sure_face == kNoFeature) return false;
  const SurfaceFace& face = ground_.features.faces[state.sure_face];
  const double height = face.normal.dot(centre - ground_.features.vertices[face.vertices[0]]);
  if (moved_ >= (height < 0.0 ? state.sure_inside_until : state.sure_outside_until)) return false;
  if (moved_ >= state.sure_foot_until) {
    const double inside = depth_in_face(ground_.features, face, centre);
    if (inside < 0.0) return false;
    state.sure_foot_until = moved_ + inside;
  }
  if (height < 0.0 && pushes_backwards(parts_.vertices[v], face.normal)) return false;
  state.distance = height;
  state.seen = centre;
  state.seen_at = moved_;
  if (height >= reach_) {
    // Another face may be nearer, as long as it is out of reach.
    state.distance = std::min(height, reach_ + (state.sure_outside_until - moved_));
    vertex_due_[v] = moved_ + state.distance - reach_;
    return true;
  }
  vertex_due_[v] = moved_;
  ContactPoint contact;
  contact.block_feature = parts_.vertices[v];
  contact.ground_feature = contact.ground_face = state.sure_face;
  contact.normal = face.normal;
  contact.overlap = reach_ - height;
  contact.foot = centre + (ground_.radius - height) * face.normal;
  contacts_.push_back(contact);
  return true;
}

void ContactSearch::add_inside_contact(std::uint32_t v, const Vec3& centre,
                                       const NearestPoint& nearest) {
  ContactPoint contact;
  contact.block_feature = parts_.vertices[v];
  contact.ground_feature = contact.ground_face = nearest.face;
  contact.normal = push_of(nearest, centre);
  const double height = contact.normal.dot(centre - nearest.point);
  contact.overlap = reach_ - height;
  contact.foot = centre + (ground_.radius - height) * contact.normal;
  contacts_.push_back(contact);
}

void ContactSearch::add_outside_contacts(std::uint32_t v, const Vec3& centre) {
  const SurfaceFeatures& ground = ground_.features;
  const std::uint32_t vertex = parts_.vertices[v];
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
  for (const LocalGround::Face& local : part_states_[vertex_states_[v].part].ground.faces) {
    const double near = reach_ + local.radius;
    if ((centre - local.middle).squaredNorm() > near * near) continue;
    const std::uint32_t f = local.face;
    const SurfaceFace& face = ground.faces[f];
    const double height = face.normal.dot(centre - ground.vertices[face.vertices[0]]);
    if (std::abs(height) >= reach_) continue;
    if (height >= 0.0 && depth_in_face(ground, face, centre) >= 0.0) {
      touch(f, centre - height * face.normal, face.normal, height);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const SurfaceEdge& edge = ground.edges[face.edges[k]];
      // Each edge once. Over one sharper than a right angle lies air that is behind the plane of
      // either face, but behind a border there is none.
      if (edge.faces[0] == f && edge.convex() && (height >= 0.0 || edge.kind == EdgeKind::kRidge)) {
        const double along = edge.direction.dot(centre - ground.vertices[edge.vertices[0]]);
        if (along >= 0.0 && along <= edge.length) {
          const Vec3 on_edge = ground.vertices[edge.vertices[0]] + along * edge.direction;
          const Vec3 out = centre - on_edge;
          const double distance = out.norm();
          if (distance > 0.0 && distance < reach_) {
            const Vec3 normal = out / distance;
            if (in_arc(ground, edge, normal) && meets_vertex(vertex, normal)) {
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

}  // namespace clast::dem_detail

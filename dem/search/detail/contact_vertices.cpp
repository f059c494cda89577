// Contacts of block vertices: separation bounds and contact tests.
#include <algorithm>
#include <cmath>
#include <span>

#include "dem/search/terrain_narrow_phase.hpp"

namespace clast::dem_detail {
namespace {

/// A vertex this many margins above the bounding plane of the ground near its part needs no test.
constexpr double kEnough = 0.25;
/// Faces up to this many margins farther than the nearest are distinguished from it.
constexpr double kDistinctGroundMargins = 4.0;

}  // namespace

void TerrainNarrowPhase::update_vertices(std::uint32_t p, const AccumulatedDisplacement& ahead,
                                         FoundContacts& found) {
  NearPart& part = *part_states_[p].near;
  const AccumulatedDisplacement displacement = part.displacement, then = displacement + ahead;
  EarliestBoundExpiry first(displacement);
  const std::span<const SeparationBound> separation_bound(part.vertex_bounds);
  if (!part.other_vertices.is_expired(then)) {
    if (part.expired_vertices.empty()) return;
    first.include(part.other_vertices);
    std::erase_if(part.expired_vertices, [&](std::uint32_t v) {
      update_vertex(part, v, ahead, found);
      if (separation_bound[v].is_expired(displacement)) return false;
      first.include(separation_bound[v]);
      return true;
    });
  } else {
    part.expired_vertices.clear();
    for (std::uint32_t v = 0; v < separation_bound.size(); ++v) {
      if (separation_bound[v].is_expired(then)) {
        update_vertex(part, v, ahead, found);
        if (separation_bound[v].is_expired(displacement)) {
          part.expired_vertices.push_back(v);
          continue;
        }
      }
      first.include(separation_bound[v]);
    }
  }
  part.other_vertices = first.separation_bound();
}

void TerrainNarrowPhase::update_vertex(NearPart& part, std::uint32_t v,
                                       const AccumulatedDisplacement& ahead, FoundContacts& found) {
  const Vec3 centre = in_ground_frame(block_.vertices[block_vertex(part, v)]);
  if (update_nearest_face(part, v, centre, found)) return;
  const SeparationBound by_closest = plane_separation_bound(part, v, centre);
  if (!by_closest.is_expired(part.displacement + ahead)) {
    part.vertex_bounds[v] = by_closest;
    return;
  }
  const BoundingPlane& plane = part.ground.plane;
  const double above = plane.clearance(centre) - reach_;
  if (above > kEnough * margin_) {
    const SeparationBound by_plane =
        separation_bound(part, plane.normal, above, remaining_complete_distance(part) - reach_);
    if (!by_plane.is_expired(part.displacement + ahead)) {
      part.vertices[v].outside = true;
      part.vertex_bounds[v] = by_plane;
      return;
    }
  }
  if (part.vertices[v].outside) {
    const SeparationBound clear = ground_separation_bound(part, v, centre);
    if (!clear.is_expired(part.displacement)) {
      part.vertex_bounds[v] = clear;
      return;
    }
  }
  measure_vertex(part, v, centre, found);
}

SeparationBound TerrainNarrowPhase::plane_separation_bound(const NearPart& part, std::uint32_t v,
                                                           const Vec3& centre) const {
  const VertexState& state = part.vertices[v];
  if (state.closest_plane == kNoFeature) return {};
  const LocalFaces::Face& face = part.ground.faces[state.closest_plane];
  const double height = face.normal.dot(centre) - face.offset - reach_;
  if (!(height > 0.0)) return {};
  const FaceNormalComponents& tilt = part.tilts[state.closest_plane];
  EarliestBoundExpiry first(part.displacement);
  first.include(state.other_features_bound);
  first.include(
      SeparationCoefficients{tilt.axial / height, tilt.transverse / height}.separation_bound(
          part.displacement));
  return first.separation_bound();
}

SeparationBound TerrainNarrowPhase::ground_separation_bound(NearPart& part, std::uint32_t v,
                                                            const Vec3& centre) {
  VertexState& state = part.vertices[v];
  state.closest_plane = kNoFeature;
  const double complete = remaining_complete_distance(part) - reach_;
  if (!(complete > 0.0)) return {};
  double apart_from_far = complete;
  SeparationCoefficients others, plane;
  std::uint32_t closest = kNoFeature;
  for (std::uint32_t i = 0; i < part.ground.faces.size(); ++i) {
    const LocalFaces::Face& face = part.ground.faces[i];
    const FaceNormalComponents& tilt = part.tilts[i];
    // The separating plane is that of the face, or one that touches its bounding sphere.
    const double height = face.normal.dot(centre) - face.offset - reach_;
    const double by_plane = height * tilt.displacement_per_height;
    const double ball = face.radius + reach_, near = ball + std::max(0.0, by_plane);
    const double squared = (centre - face.centre).squaredNorm();
    if (!tilt.is_at_border() && squared > near * near) {
      const double farther = ball + apart_from_far;
      if (squared < farther * farther) apart_from_far = std::sqrt(squared) - ball;
    } else if (height > 0.0) {
      SeparationCoefficients by_this{tilt.axial / height, tilt.transverse / height};
      if (by_this.sum() > plane.sum()) {
        std::swap(by_this, plane);
        closest = i;
      }
      others.include(by_this);
    } else if (tilt.is_at_border()) {
      return {};
    } else {
      const NearestPoint nearest = nearest_point_on_face(ground_.features, face.face, centre);
      const double distance = nearest.distance - reach_;
      if (!(distance > 0.0)) return {};
      const Vec3 away = (centre - nearest.point) / nearest.distance;
      const double axial = std::min(std::abs(away.dot(part.axis)), 1.0);
      others.include({axial / distance, std::sqrt(1.0 - axial * axial) / distance});
    }
  }
  others.include({1.0 / apart_from_far, 1.0 / apart_from_far});
  state.closest_plane = closest;
  state.other_features_bound = others.separation_bound(part.displacement);
  others.include(plane);
  return others.separation_bound(part.displacement);
}

void TerrainNarrowPhase::measure_vertex(NearPart& part, std::uint32_t v, const Vec3& centre,
                                        FoundContacts& found) {
  VertexState& state = part.vertices[v];
  const double complete = remaining_complete_distance(part);
  const LocalFaces::NearestFace of_faces = part.ground.nearest(
      ground_.features, centre, complete, kDistinctGroundMargins * margin_, state.near_face);
  const NearestPoint& nearest = of_faces.nearest;
  state.near_face = of_faces.entry;
  const double depth = std::abs(nearest.distance);

  state.nearest_face = kNoFeature;
  state.outside = nearest.distance >= reach_ && depth < complete;
  part.vertex_bounds[v] = {};
  if (depth >= complete) {
    // Nothing is known about ground that is not listed.
    part.vertex_bounds[v] = separation_bound(part, part.axis, complete - reach_, complete - reach_);
    return;
  }
  const bool inverted =
      nearest.distance < 0.0 && tests_.is_inverted_push(block_vertex(part, v), centre, nearest);
  if (nearest.within_face && !inverted) {
    state.nearest_face = nearest.face;
    state.foot_on_face_until = part.displacement.total;
    state.inside_until = part.displacement.total + 0.5 * (of_faces.second - depth);
    state.outside_until = part.displacement.total + (of_faces.second - reach_);
  }
  if (nearest.distance >= reach_) {
    const Vec3 away = nearest.within_face ? nearest.normal : Vec3((centre - nearest.point) / depth);
    part.vertex_bounds[v] =
        separation_bound(part, away, nearest.distance - reach_, of_faces.second - reach_);
    return;
  }
  const std::uint32_t vertex = block_vertex(part, v);
  if (nearest.distance >= 0.0) {
    return tests_.add_outside_contacts(vertex, centre, part.ground.faces, found.contacts);
  }
  found.contacts.push_back(tests_.make_inside_contact(
      vertex, centre,
      inverted ? tests_.nearest_valid_push_point(vertex, centre, nearest, part.ground.faces)
               : nearest));
}

bool TerrainNarrowPhase::update_nearest_face(NearPart& part, std::uint32_t v, const Vec3& centre,
                                             FoundContacts& found) {
  VertexState& state = part.vertices[v];
  if (state.nearest_face == kNoFeature) return false;
  const double displacement = part.displacement.total;
  const SurfaceFace& face = ground_.features.faces[state.nearest_face];
  const double height = face.normal.dot(centre - ground_.features.vertices[face.vertices[0]]);
  if (displacement >= (height < 0.0 ? state.inside_until : state.outside_until)) return false;
  if (height >= reach_) {
    const double others = state.outside_until - displacement;
    if (others < height - reach_) return false;
    state.outside = true;
    part.vertex_bounds[v] = separation_bound(part, face.normal, height - reach_, others);
    return true;
  }
  if (displacement >= state.foot_on_face_until) {
    const double inside = distance_inside_face(ground_.features, face, centre);
    if (inside < 0.0) return false;
    state.foot_on_face_until = displacement + inside;
  }
  if (height < 0.0 && tests_.pushes_through_block(block_vertex(part, v), face.normal)) return false;
  part.vertex_bounds[v] = {};
  ContactPoint contact;
  contact.block_feature = block_vertex(part, v);
  contact.ground_feature = contact.ground_face = state.nearest_face;
  contact.normal = face.normal;
  contact.overlap = reach_ - height;
  contact.surface_point = centre + (ground_.radius - height) * face.normal;
  found.contacts.push_back(contact);
  return true;
}

}  // namespace clast::dem_detail

// Contacts of block vertices: when each must be measured, and how it touches.
#include <algorithm>
#include <cmath>
#include <span>

#include "dem/search/contact_search.hpp"

namespace clast::dem_detail {
namespace {

/// The plane over the ground near a part settles it for a vertex this many margins above it.
constexpr double kEnough = 0.25;
/// Faces up to this many margins behind the nearest are distinguished from it.
constexpr double kDistinctGroundMargins = 4.0;

}  // namespace

void ContactSearch::update_vertices(std::uint32_t p, const Way& ahead, Found& found) {
  NearPart& part = *part_states_[p].near;
  const Way way = part.way, then = way + ahead;
  FirstDue first(way);
  const std::span<const Asleep> asleep(part.vertex_asleep);
  if (!part.other_vertices.due(then)) {
    if (part.due_vertices.empty()) return;
    first.include(part.other_vertices);
    std::erase_if(part.due_vertices, [&](std::uint32_t v) {
      update_vertex(part, v, ahead, found);
      if (asleep[v].due(way)) return false;
      first.include(asleep[v]);
      return true;
    });
  } else {
    part.due_vertices.clear();
    for (std::uint32_t v = 0; v < asleep.size(); ++v) {
      if (asleep[v].due(then)) {
        update_vertex(part, v, ahead, found);
        if (asleep[v].due(way)) {
          part.due_vertices.push_back(v);
          continue;
        }
      }
      first.include(asleep[v]);
    }
  }
  part.other_vertices = first.asleep();
}

void ContactSearch::update_vertex(NearPart& part, std::uint32_t v, const Way& ahead, Found& found) {
  const Vec3 centre = placed(block_.vertices[block_vertex(part, v)]);
  if (update_sure_face(part, v, centre, found)) return;
  const Asleep by_closest = clear_of_plane(part, v, centre);
  if (!by_closest.due(part.way + ahead)) {
    part.vertex_asleep[v] = by_closest;
    return;
  }
  const GroundPlane& plane = part.ground.plane;
  const double above = plane.clearance(centre) - reach_;
  if (above > kEnough * margin_) {
    const Asleep by_plane = asleep(part, plane.normal, above, completeness(part) - reach_);
    if (!by_plane.due(part.way + ahead)) {
      part.vertices[v].outside = true;
      part.vertex_asleep[v] = by_plane;
      return;
    }
  }
  if (part.vertices[v].outside) {
    const Asleep clear = clear_of_ground(part, v, centre);
    if (!clear.due(part.way)) {
      part.vertex_asleep[v] = clear;
      return;
    }
  }
  measure_vertex(part, v, centre, found);
}

Asleep ContactSearch::clear_of_plane(const NearPart& part, std::uint32_t v,
                                     const Vec3& centre) const {
  const VertexState& state = part.vertices[v];
  if (state.closest_plane == kNoFeature) return {};
  const LocalFaces::Face& face = part.ground.faces[state.closest_plane];
  const double height = face.normal.dot(centre) - face.offset - reach_;
  if (!(height > 0.0)) return {};
  const FaceTilt& tilt = part.tilts[state.closest_plane];
  FirstDue first(part.way);
  first.include(state.others);
  first.include(Separation{tilt.across / height, tilt.along / height}.asleep(part.way));
  return first.asleep();
}

Asleep ContactSearch::clear_of_ground(NearPart& part, std::uint32_t v, const Vec3& centre) {
  VertexState& state = part.vertices[v];
  state.closest_plane = kNoFeature;
  const double complete = completeness(part) - reach_;
  if (!(complete > 0.0)) return {};
  double apart_from_far = complete;
  Separation others, plane;
  std::uint32_t closest = kNoFeature;
  for (std::uint32_t i = 0; i < part.ground.faces.size(); ++i) {
    const LocalFaces::Face& face = part.ground.faces[i];
    const FaceTilt& tilt = part.tilts[i];
    // Either the plane of the face keeps them apart or one that touches the ball around it.
    const double height = face.normal.dot(centre) - face.offset - reach_;
    const double by_plane = height * tilt.way_per_height;
    const double ball = face.radius + reach_, near = ball + std::max(0.0, by_plane);
    const double squared = (centre - face.middle).squaredNorm();
    if (!tilt.at_border() && squared > near * near) {
      const double farther = ball + apart_from_far;
      if (squared < farther * farther) apart_from_far = std::sqrt(squared) - ball;
    } else if (height > 0.0) {
      Separation by_this{tilt.across / height, tilt.along / height};
      if (by_this.sum() > plane.sum()) {
        std::swap(by_this, plane);
        closest = i;
      }
      others.include(by_this);
    } else if (tilt.at_border()) {
      return {};
    } else {
      const NearestPoint nearest = nearest_on_face(ground_.features, face.face, centre);
      const double apart = nearest.distance - reach_;
      if (!(apart > 0.0)) return {};
      const Vec3 away = (centre - nearest.point) / nearest.distance;
      const double across = std::min(std::abs(away.dot(part.axis)), 1.0);
      others.include({across / apart, std::sqrt(1.0 - across * across) / apart});
    }
  }
  others.include({1.0 / apart_from_far, 1.0 / apart_from_far});
  state.closest_plane = closest;
  state.others = others.asleep(part.way);
  others.include(plane);
  return others.asleep(part.way);
}

void ContactSearch::measure_vertex(NearPart& part, std::uint32_t v, const Vec3& centre,
                                   Found& found) {
  VertexState& state = part.vertices[v];
  const double complete = completeness(part);
  const LocalFaces::Nearest of_faces = part.ground.nearest(
      ground_.features, centre, complete, kDistinctGroundMargins * margin_, state.near_face);
  const NearestPoint& nearest = of_faces.nearest;
  state.near_face = of_faces.entry;
  const double depth = std::abs(nearest.distance);

  state.sure_face = kNoFeature;
  state.outside = nearest.distance >= reach_ && depth < complete;
  part.vertex_asleep[v] = {};
  if (depth >= complete) {
    // Beyond the list nothing is known, not even the side.
    part.vertex_asleep[v] = asleep(part, part.axis, complete - reach_, complete - reach_);
    return;
  }
  const bool backwards =
      nearest.distance < 0.0 && tests_.is_backwards(block_vertex(part, v), centre, nearest);
  if (nearest.within_face && !backwards) {
    state.sure_face = nearest.face;
    state.sure_foot_until = part.way.whole;
    state.sure_inside_until = part.way.whole + 0.5 * (of_faces.second - depth);
    state.sure_outside_until = part.way.whole + (of_faces.second - reach_);
  }
  if (nearest.distance >= reach_) {
    const Vec3 away = nearest.within_face ? nearest.normal : Vec3((centre - nearest.point) / depth);
    part.vertex_asleep[v] = asleep(part, away, nearest.distance - reach_, of_faces.second - reach_);
    return;
  }
  const std::uint32_t vertex = block_vertex(part, v);
  if (nearest.distance >= 0.0) {
    return tests_.add_outside(vertex, centre, part.ground.faces, found.contacts);
  }
  found.contacts.push_back(tests_.inside(
      vertex, centre,
      backwards ? tests_.nearest_forwards(vertex, centre, nearest, part.ground.faces) : nearest));
}

bool ContactSearch::update_sure_face(NearPart& part, std::uint32_t v, const Vec3& centre,
                                     Found& found) {
  VertexState& state = part.vertices[v];
  if (state.sure_face == kNoFeature) return false;
  const double way = part.way.whole;
  const SurfaceFace& face = ground_.features.faces[state.sure_face];
  const double height = face.normal.dot(centre - ground_.features.vertices[face.vertices[0]]);
  if (way >= (height < 0.0 ? state.sure_inside_until : state.sure_outside_until)) return false;
  if (height >= reach_) {
    const double others = state.sure_outside_until - way;
    if (others < height - reach_) return false;
    state.outside = true;
    part.vertex_asleep[v] = asleep(part, face.normal, height - reach_, others);
    return true;
  }
  if (way >= state.sure_foot_until) {
    const double inside = depth_in_face(ground_.features, face, centre);
    if (inside < 0.0) return false;
    state.sure_foot_until = way + inside;
  }
  if (height < 0.0 && tests_.pushes_backwards(block_vertex(part, v), face.normal)) return false;
  part.vertex_asleep[v] = {};
  ContactPoint contact;
  contact.block_feature = block_vertex(part, v);
  contact.ground_feature = contact.ground_face = state.sure_face;
  contact.normal = face.normal;
  contact.overlap = reach_ - height;
  contact.foot = centre + (ground_.radius - height) * face.normal;
  found.contacts.push_back(contact);
  return true;
}

}  // namespace clast::dem_detail

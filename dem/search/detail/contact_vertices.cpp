// Contacts of block vertices: filter, exact tests and separation bounds.
#include <algorithm>
#include <cmath>

#include "dem/search/terrain_narrow_phase.hpp"

namespace clast::dem_detail {
namespace {

/// A face this many margins from the bounding sphere of a part is not compared with its vertices.
constexpr double kSphereMargins = 0.5;
/// Depth of vertices of which nothing is known, m.
constexpr double kUnknownDepth = 1e100;

}  // namespace

void TerrainNarrowPhase::update_vertices(std::uint32_t p, const AccumulatedDisplacement& ahead,
                                         FoundContacts& found) {
  NearPart& part = *part_states_[p].near;
  if (!part.all_vertices.is_expired(part.displacement + ahead)) return;
  filter_part_vertices(p);
  const std::uint32_t first = parts_.parts[p].first_vertex, end = parts_.parts[p].end_vertex;
  const FilteredVertices* group = scratch().vertices.data();
  const std::size_t known_contacts = found.contacts.size();
  for (std::uint32_t v = first; v < end; v += 4, ++group) {
    for (std::uint32_t lane = 0; lane < 4 && v + lane < end; ++lane) {
      if (group->result[lane] == FilteredVertices::kClear) continue;
      const std::uint32_t vertex = parts_.vertices[v + lane];
      const auto face = static_cast<std::uint32_t>(group->face[lane]);
      const Vec3 centre(group->placed.x[lane], group->placed.y[lane], group->placed.z[lane]);
      if (group->result[lane] == FilteredVertices::kUnknown ||
          !add_face_contact(part, vertex, centre, face, found)) {
        test_vertex(part, vertex, centre, face, found);
      }
    }
  }
  part.depth_known = true;
  part.all_vertices =
      found.contacts.size() > known_contacts ? SeparationBound() : vertices_separation_bound(p);
}

void TerrainNarrowPhase::filter_part_vertices(std::uint32_t p) {
  const NearPart& part = *part_states_[p].near;
  const BlockPart& of_block = parts_.parts[p];
  // A vertex inside the ground was a contact of the last search, or has entered the ground since.
  const double max_depth = part.depth_known ? deepest_ + last_move_ : kUnknownDepth;
  const double touching = of_block.radius + std::max(reach_, max_depth);
  const std::vector<FacePrism>& prisms = part.ground.prisms;
  IndexList& close_faces = scratch().close_faces;
  close_faces.fill_if(static_cast<std::uint32_t>(prisms.size()), [&](std::uint32_t i) {
    return std::abs(prisms[i].height(part.centre)) <= touching &&
           prisms[i].distance_beside(part.centre) <= touching;
  });
  const std::size_t group_count = of_block.end_group - of_block.first_group;
  std::vector<FilteredVertices>& vertices = scratch().vertices;
  vertices.resize(std::max(vertices.size(), group_count));
  filter_vertices({.rotation = tests_.rotation().data(),
                   .position = tests_.position().data(),
                   .reach = reach_,
                   .max_depth = max_depth},
                  parts_.vertex_groups.data() + of_block.first_group, group_count, prisms.data(),
                  close_faces.begin(), close_faces.size(), vertices.data());
}

bool TerrainNarrowPhase::add_face_contact(const NearPart& part, std::uint32_t vertex,
                                          const Vec3& centre, std::uint32_t listed_face,
                                          FoundContacts& found) const {
  const std::uint32_t index = part.ground.faces[listed_face].face;
  const SurfaceFace& face = ground_.features.faces[index];
  const double height = face.normal.dot(centre - ground_.features.vertices[face.vertices[0]]);
  if (height >= reach_) return true;  // by rounding
  if (-height >= remaining_complete_distance(part)) return false;
  if (height < 0.0 && tests_.pushes_through_block(vertex, face.normal)) return false;
  ContactPoint& contact = found.contacts.emplace_back();
  contact.block_feature = vertex;
  contact.ground_feature = contact.ground_face = index;
  contact.normal = face.normal;
  contact.overlap = reach_ - height;
  contact.surface_point = centre + (ground_.radius - height) * face.normal;
  return true;
}

void TerrainNarrowPhase::test_vertex(const NearPart& part, std::uint32_t vertex, const Vec3& centre,
                                     std::uint32_t near_face, FoundContacts& found) const {
  const double complete = remaining_complete_distance(part);
  const NearestPoint nearest =
      part.ground.nearest(ground_.features, centre, complete, 0.0, near_face).nearest;
  // Nothing is known about ground that is not listed.
  if (std::abs(nearest.distance) >= complete || nearest.distance >= reach_) return;
  if (nearest.distance >= 0.0) {
    return tests_.add_outside_contacts(vertex, centre, part.ground.faces, found.contacts);
  }
  found.contacts.push_back(tests_.make_inside_contact(
      vertex, centre,
      tests_.is_inverted_push(vertex, centre, nearest)
          ? tests_.nearest_valid_push_point(vertex, centre, nearest, part.ground.faces)
          : nearest));
}

SeparationBound TerrainNarrowPhase::vertices_separation_bound(std::uint32_t p) const {
  const NearPart& part = *part_states_[p].near;
  const BlockPart& of_block = parts_.parts[p];
  const double complete = remaining_complete_distance(part) - reach_;
  if (!(complete > 0.0)) return {};
  const double touching = of_block.radius + reach_, enough = kSphereMargins * margin_;
  double from_faces = complete;
  SeparationCoefficients all;
  for (std::size_t i = 0; i < part.ground.prisms.size(); ++i) {
    // First the bounding sphere of the part is measured, then, if it is near, the vertices.
    const FacePrism& prism = part.ground.prisms[i];
    const FaceNormalComponents& tilt = part.tilts[i];
    const double height = prism.height(part.centre);
    double over_plane = height - touching;
    double from_face = std::max(std::abs(height), prism.distance_beside(part.centre)) - touching;
    if (tilt.is_at_border() ||
        std::max(over_plane * tilt.displacement_per_height, from_face) < enough) {
      const PrismClearance clearance = measure_prism_clearance(
          prism, tilt.displacement_per_height, reach_, scratch().vertices.data(),
          of_block.end_group - of_block.first_group);
      if (!(clearance.over_plane > 0.0 && clearance.from_face > 0.0)) return {};
      over_plane = clearance.over_plane;
      from_face = clearance.from_face;
    } else if (over_plane * tilt.displacement_per_height > from_face) {
      from_face = 1e300;
    } else {
      over_plane = 1e300;
    }
    from_faces = std::min(from_faces, from_face);
    all.include({tilt.axial / over_plane, tilt.transverse / over_plane});
  }
  all.include({1.0 / from_faces, 1.0 / from_faces});
  return all.separation_bound(part.displacement);
}

}  // namespace clast::dem_detail

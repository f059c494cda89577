// Contacts of block vertices: filter, exact tests and separation bounds.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "dem/search/terrain_narrow_phase.hpp"

namespace clast::dem_detail {
namespace {

/// A face this many margins from the bounding sphere of a part is not compared with its vertices.
constexpr double kSphereMargins = 0.5;
/// The list of the ground faces that may be in contact reaches this many margins ahead.
constexpr double kCloseFacesMargins = 0.1;
/// Beside vertices in contact, the others get a separation bound if it lasts for this many moves as
/// long as the last. Otherwise it costs more than their comparison in each search.
constexpr double kWorthwhileMoves = 8.0;
/// A bounding sphere is measured instead of this many groups of vertices, or more. One group is as
/// fast as the sphere.
constexpr std::size_t kGroupsInSphere = 2;
/// Depth of vertices of which nothing is known, m.
constexpr double kUnknownDepth = 1e100;

}  // namespace

void TerrainNarrowPhase::update_vertices(std::uint32_t p, const AccumulatedDisplacement& ahead,
                                         FoundContacts& found) {
  NearPart& part = *part_states_[p].near;
  const bool all = part.other_vertices.is_expired(part.displacement + ahead);
  if (!all && part.touching_groups.empty()) return;
  auto& [groups, vertices, touching_groups, clearances] = scratch().vertex_test;
  groups = part.touching_groups;
  if (all) {
    groups.resize(parts_.parts[p].end_group - parts_.parts[p].first_group);
    std::iota(groups.begin(), groups.end(), parts_.parts[p].first_group);
  }
  filter_groups(p);
  touching_groups.clear();
  std::size_t separated = 0;  // the first of `vertices` are those of groups without contact
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!vertices[g].all_clear()) {
      const std::size_t known_contacts = found.contacts.size();
      add_group_contacts(p, groups[g], vertices[g], found);
      if (found.contacts.size() > known_contacts) {
        touching_groups.push_back(groups[g]);
        continue;
      }
    }
    if (separated != g) vertices[separated] = vertices[g];
    ++separated;
  }
  part.depth_known = true;
  if (all) {
    const std::span<const FilteredVertices> others(vertices.data(), separated);
    part.touching_groups.assign(touching_groups.begin(), touching_groups.end());
    part.other_vertices = touching_groups.empty() || stay_separated(others)
                              ? vertices_separation_bound(p, others)
                              : SeparationBound();
  } else if (touching_groups.empty()) {
    part.touching_groups.clear();
    part.other_vertices = {};
    update_vertices(p, ahead, found);
  }
}

void TerrainNarrowPhase::add_group_contacts(std::uint32_t p, std::uint32_t group,
                                            const FilteredVertices& vertices,
                                            FoundContacts& found) const {
  const NearPart& part = *part_states_[p].near;
  const BlockPart& of_block = parts_.parts[p];
  const std::uint32_t first = of_block.first_vertex + 4 * (group - of_block.first_group);
  for (std::uint32_t lane = 0; lane < std::min(4u, of_block.end_vertex - first); ++lane) {
    if (vertices.result[lane] == FilteredVertices::kClear) continue;
    const std::uint32_t vertex = parts_.vertices[first + lane];
    const auto face = static_cast<std::uint32_t>(vertices.face[lane]);
    const Vec3 centre(vertices.placed.x[lane], vertices.placed.y[lane], vertices.placed.z[lane]);
    if (vertices.result[lane] == FilteredVertices::kUnknown ||
        !add_face_contact(part, vertex, centre, face, found)) {
      test_vertex(part, vertex, centre, face, found);
    }
  }
}

void TerrainNarrowPhase::filter_groups(std::uint32_t p) {
  const NearPart& part = *part_states_[p].near;
  auto& [groups, vertices, touching_groups, clearances] = scratch().vertex_test;
  // A vertex inside the ground was a contact of the last search, or has entered the ground since.
  const double max_depth = part.depth_known ? deepest_ + last_move_ : kUnknownDepth;
  list_close_faces(p, max_depth);
  if (vertices.size() < groups.size()) vertices.resize(groups.size());
  filter_vertices({.rotation = tests_.rotation().data(),
                   .position = tests_.position().data(),
                   .reach = reach_,
                   .max_depth = max_depth},
                  parts_.vertex_groups.data(), groups.data(), groups.size(),
                  part.ground.prisms.data(), part.close_faces.data(), part.close_faces.size(),
                  vertices.data());
}

void TerrainNarrowPhase::list_close_faces(std::uint32_t p, double max_depth) {
  NearPart& part = *part_states_[p].near;
  if (part.displacement.total < part.close_faces_until && max_depth <= part.close_faces_depth) {
    return;
  }
  const double slack = kCloseFacesMargins * margin_;
  part.close_faces_until = part.displacement.total + slack;
  part.close_faces_depth = max_depth + slack;
  const double touching = parts_.parts[p].radius + std::max(reach_, part.close_faces_depth) + slack;
  part.close_faces.clear();
  for (std::uint32_t i = 0; i < part.ground.prisms.size(); ++i) {
    const FacePrism& prism = part.ground.prisms[i];
    if (std::abs(prism.height(part.centre)) <= touching &&
        prism.distance_beside(part.centre) <= touching) {
      part.close_faces.push_back(i);
    }
  }
}

bool TerrainNarrowPhase::stay_separated(std::span<const FilteredVertices> vertices) const {
  const double distance = reach_ + kWorthwhileMoves * last_move_;
  for (const FilteredVertices& group : vertices) {
    for (const double squared : group.squared_distance) {
      if (squared < distance * distance) return false;
    }
  }
  return true;
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

SeparationBound TerrainNarrowPhase::vertices_separation_bound(
    std::uint32_t p, std::span<const FilteredVertices> vertices) const {
  const NearPart& part = *part_states_[p].near;
  const BlockPart& of_block = parts_.parts[p];
  const double complete = remaining_complete_distance(part) - reach_;
  if (!(complete > 0.0)) return {};
  const double touching = of_block.radius + reach_, enough = kSphereMargins * margin_;
  std::vector<PrismClearance>& clearances = scratch().vertex_test.clearances;
  clearances.clear();
  double from_faces = complete;
  SeparationCoefficients all;
  for (std::uint32_t i = 0; i < part.ground.prisms.size(); ++i) {
    const FaceNormalComponents& tilt = part.tilts[i];
    if (vertices.size() >= kGroupsInSphere && !tilt.is_at_border()) {
      const FacePrism& prism = part.ground.prisms[i];
      const double height = prism.height(part.centre);
      const double over_plane = height - touching,
                   by_plane = over_plane * tilt.displacement_per_height;
      const double from_face =
          std::max(std::abs(height), prism.distance_beside(part.centre)) - touching;
      if (std::max(by_plane, from_face) >= enough) {
        if (by_plane > from_face) {
          all.include_distance(tilt.axial, tilt.transverse, over_plane);
        } else {
          from_faces = std::min(from_faces, from_face);
        }
        continue;
      }
    }
    clearances.push_back({.face = i, .displacement_per_height = tilt.displacement_per_height});
  }
  measure_prism_clearances(part.ground.prisms.data(), reach_, vertices.data(), vertices.size(),
                           clearances.data(), clearances.size());
  for (const PrismClearance& clearance : clearances) {
    if (!(clearance.over_plane > 0.0 && clearance.from_face > 0.0)) return {};
    const FaceNormalComponents& tilt = part.tilts[clearance.face];
    all.include_distance(tilt.axial, tilt.transverse, clearance.over_plane);
    from_faces = std::min(from_faces, clearance.from_face);
  }
  all.include_distance(1.0, 1.0, from_faces);
  return all.separation_bound(part.displacement);
}

}  // namespace clast::dem_detail

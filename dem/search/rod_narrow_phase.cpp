#include "dem/search/rod_narrow_phase.hpp"

#include <algorithm>
#include <cmath>

#include "dem/surface/ghost_edges.hpp"
#include "dem/surface/segment_distance.hpp"

namespace clast::dem_detail {
namespace {

/// Returns the foot of a point on a rod; empty if it does not lie between the ends.
std::optional<Vec3> foot_between_ends(const Vec3& start, const Vec3& direction, double length,
                                      const Vec3& point) {
  const double along = direction.dot(point - start);
  if (along <= 0.0 || along >= length) return std::nullopt;
  return start + along * direction;
}

}  // namespace

RodNarrowPhase::RodNarrowPhase(const IndexedSurface& ground, const IndexedSurface& block)
    : ground_(ground), block_(block.features), reach_(ground.radius + block.radius) {}

std::vector<ContactPoint>& RodNarrowPhase::find_contacts(const Pose& ground_from_body) {
  rotation_ = ground_from_body.rotation.toRotationMatrix();
  contacts_.clear();
  clearance_ = 1e300;
  block_vertices_in_ground_.clear();
  for (const Vec3& vertex : block_.vertices) {
    block_vertices_in_ground_.push_back(rotation_ * vertex + ground_from_body.translation);
  }
  for (std::uint32_t v = 0; v < block_.vertices.size(); ++v) find_vertex_contacts(v);
  for (std::uint32_t e = 0; e < block_.edges.size(); ++e) find_edge_contacts(e);
  return contacts_;
}

bool RodNarrowPhase::is_vertex_contact(std::uint32_t block_vertex, std::uint32_t ground_vertex,
                                       const Vec3& out) const {
  return (block_vertex == kNoFeature ||
          is_in_normal_cone(block_, block_vertex, rotation_.transpose() * -out)) &&
         (ground_vertex == kNoFeature || is_in_normal_cone(ground_.features, ground_vertex, out));
}

void RodNarrowPhase::find_vertex_contacts(std::uint32_t v) {
  const SurfaceFeatures& ground = ground_.features;
  const auto vertices = static_cast<std::uint32_t>(ground.vertices.size());
  ContactPoint contact;
  contact.kind = ContactKind::kVertexGround;
  contact.block_feature = v;
  for (std::uint32_t g = 0; g < vertices; ++g) {
    contact.ground_feature = g;
    const Vec3 out = (block_vertices_in_ground_[v] - ground.vertices[g]).normalized();
    if (is_vertex_contact(v, g, out))
      set_contact(contact, ground.vertices[g], block_vertices_in_ground_[v]);
  }
  for (std::uint32_t e = 0; e < ground.edges.size(); ++e) {
    const SurfaceEdge& edge = ground.edges[e];
    contact.ground_feature = vertices + e;
    const std::optional<Vec3> foot =
        foot_between_ends(ground.vertices[edge.vertices[0]], edge.direction, edge.length,
                          block_vertices_in_ground_[v]);
    if (foot &&
        is_vertex_contact(v, kNoFeature, (block_vertices_in_ground_[v] - *foot).normalized())) {
      set_contact(contact, *foot, block_vertices_in_ground_[v]);
    }
  }
}

void RodNarrowPhase::find_edge_contacts(std::uint32_t e) {
  const SurfaceFeatures& ground = ground_.features;
  const SurfaceEdge& edge = block_.edges[e];
  const Segment of_block{block_vertices_in_ground_[edge.vertices[0]], rotation_ * edge.direction,
                         edge.length};
  ContactPoint contact;
  contact.block_feature = e;
  contact.kind = ContactKind::kEdgeVertex;
  for (std::uint32_t g = 0; g < ground.vertices.size(); ++g) {
    contact.ground_feature = g;
    const std::optional<Vec3> foot =
        foot_between_ends(of_block.start, of_block.direction, of_block.length, ground.vertices[g]);
    if (foot && is_vertex_contact(kNoFeature, g, (*foot - ground.vertices[g]).normalized())) {
      set_contact(contact, ground.vertices[g], *foot);
    }
  }
  contact.kind = ContactKind::kEdgeEdge;
  for (std::uint32_t g = 0; g < ground.edges.size(); ++g) {
    const SurfaceEdge& other = ground.edges[g];
    const Segment of_ground = ground.segment(other);
    const ClosestSegmentPoints closest = closest_segment_points(of_block, of_ground);
    if (!closest.crossing) continue;  // the ends carry the contact of parallel rods
    contact.ground_feature = g;
    set_contact(contact, of_ground.point_at(closest.second), of_block.point_at(closest.first));
  }
}

void RodNarrowPhase::set_contact(ContactPoint& contact, const Vec3& on_ground,
                                 const Vec3& on_block) {
  const Vec3 out = on_block - on_ground;
  const double distance = out.norm();
  clearance_ = std::min(clearance_, std::max(0.0, distance - reach_));
  if (distance >= reach_ || !(distance > 0.0)) return;
  contact.normal = out / distance;
  contact.overlap = reach_ - distance;
  contact.surface_point = on_ground + ground_.radius * contact.normal;
  contacts_.push_back(contact);
}

}  // namespace clast::dem_detail

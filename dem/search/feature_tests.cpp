#include "dem/search/feature_tests.hpp"

#include <algorithm>
#include <cmath>

#include "dem/surface/ghost_edges.hpp"
#include "dem/surface/segment_distance.hpp"

namespace clast::dem_detail {
namespace {

/// Largest depth of edge and face contacts, as a fraction of the smallest side. Beyond the middle
/// of the block, the opposite side would be nearer.
constexpr double kDepthFraction = 0.5;
/// Depths that differ by less are compared exactly, m.
constexpr double kDepthRounding = 1e-9;
/// Rotation can make edges and faces deeper than all present contacts by this fraction of their
/// depth plus this many list margins.
constexpr double kDeeperFraction = 0.5, kDeeperMargins = 0.25;
/// Depth limit over the needed depth: value when set, and value above which it is lowered.
constexpr double kAllowedFraction = 1.5, kTooDeepFraction = 4.0;

}  // namespace

void add_unique_contact(std::vector<ContactPoint>& contacts, const ContactPoint& contact) {
  for (const ContactPoint& known : contacts) {
    const bool related =
        known.kind == contact.kind && (known.block_feature == contact.block_feature ||
                                       (known.kind != ContactKind::kVertexGround &&
                                        known.ground_feature == contact.ground_feature));
    if (related && known.normal.dot(contact.normal) > 1.0 - 1e-12 &&
        (known.surface_point - contact.surface_point).squaredNorm() < 1e-18) {
      return;
    }
  }
  contacts.push_back(contact);
}

bool ContactDepthLimit::update(double deepest, double margin) {
  const double needed =
      deepest > 0.0 ? (1.0 + kDeeperFraction) * deepest + kDeeperMargins * margin : 0.0;
  const bool deeper = needed > depth_;
  if (deeper || kTooDeepFraction * needed < depth_) depth_ = kAllowedFraction * needed;
  return deeper;
}

FeatureTests::FeatureTests(const IndexedSurface& ground, const BlockSurface& block, double size)
    : ground_(ground),
      block_(block.features),
      reach_(block.radius + ground.radius),
      bounding_radius_(block.bounding_radius),
      depth_limit_(kDepthFraction * size) {}

bool FeatureTests::can_vertex_touch(std::uint32_t vertex, const Vec3& normal) const {
  return is_in_normal_cone(block_, vertex, -(rotation_.transpose() * normal));
}

bool FeatureTests::can_edge_touch(std::uint32_t edge, const Vec3& normal) const {
  return is_in_normal_arc(block_, block_.edges[edge], -(rotation_.transpose() * normal));
}

bool FeatureTests::can_edges_touch(const SurfaceEdge& of_ground, const SurfaceEdge& of_block,
                                   const Vec3& normal) const {
  const Vec3 in_body = -(rotation_.transpose() * normal);
  return is_near_normal_arc(ground_.features, of_ground, normal) &&
         is_near_normal_arc(block_, of_block, in_body);
}

FeatureSeparation FeatureTests::test_edge_edge(std::uint32_t block_edge, std::uint32_t ground_edge,
                                               std::optional<ContactPoint>& contact) const {
  const SurfaceEdge& edge = block_.edges[block_edge];
  const SurfaceEdge& other = ground_.features.edges[ground_edge];
  const Segment of_block{in_ground_frame(block_.vertices[edge.vertices[0]]),
                         rotation_ * edge.direction, edge.length};
  const Segment of_ground = ground_.features.segment(other);
  const ClosestSegmentPoints closest = closest_segment_points(of_block, of_ground);
  if (!closest.crossing) {
    return {closest.separation,
            displacement_to_crossing(closest, of_block, of_ground, position_, bounding_radius_)};
  }
  Vec3 normal = of_block.direction.cross(other.direction);
  normal *= (normal.dot(ground_.features.edge_normal(other)) >= 0.0 ? 1.0 : -1.0) / normal.norm();
  const double gap = normal.dot(of_block.start - of_ground.start);
  if (gap >= reach_ || gap < -depth_limit_ || !can_edges_touch(other, edge, normal)) {
    return {closest.separation, 0.0};
  }
  contact.emplace();
  contact->kind = ContactKind::kEdgeEdge;
  contact->block_feature = block_edge;
  contact->ground_feature = ground_edge;
  contact->ground_face = other.faces[0];
  contact->normal = normal;
  contact->overlap = reach_ - gap;
  contact->surface_point = of_ground.point_at(closest.second) + ground_.radius * normal;
  return {closest.separation, 0.0};
}

FeatureSeparation FeatureTests::test_edge_vertex(std::uint32_t block_edge,
                                                 std::uint32_t ground_vertex,
                                                 std::optional<ContactPoint>& contact) const {
  const SurfaceEdge& edge = block_.edges[block_edge];
  const Vec3& ground_point = ground_.features.vertices[ground_vertex];
  const Vec3 start = in_ground_frame(block_.vertices[edge.vertices[0]]);
  const Vec3 along = rotation_ * edge.direction;
  const double s = along.dot(ground_point - start);
  const Vec3 out = start + std::clamp(s, 0.0, edge.length) * along - ground_point;
  const double distance = out.norm();
  const double beyond = std::max(-s, s - edge.length);
  if (distance >= reach_ || beyond >= 0.0 || !(distance > 0.0)) {
    return {out, std::max({0.0, distance - reach_, beyond / relative_motion_factor(ground_point)})};
  }
  const Vec3 normal = out / distance;
  if (can_edge_touch(block_edge, normal) &&
      is_in_normal_cone(ground_.features, ground_vertex, normal)) {
    contact =
        make_vertex_contact(ContactKind::kEdgeVertex, block_edge, ground_vertex, normal, distance);
  }
  return {out, 0.0};
}

FeatureSeparation FeatureTests::test_face_vertex(std::uint32_t block_face,
                                                 std::uint32_t ground_vertex,
                                                 std::optional<ContactPoint>& contact) const {
  const SurfaceFace& face = block_.faces[block_face];
  const Vec3& ground_point = ground_.features.vertices[ground_vertex];
  const Vec3 in_body = rotation_.transpose() * (ground_point - position_);
  const double height = face.normal.dot(in_body - block_.vertices[face.vertices[0]]);
  const double moving = relative_motion_factor(ground_point);
  if (distance_inside_face(block_, face, in_body) < 0.0) {
    const Vec3 between = in_body - nearest_point_on_face(block_, block_face, in_body).point;
    const double beside = std::sqrt(std::max(0.0, between.squaredNorm() - height * height));
    return {rotation_ * between, std::max(beside, height - reach_) / moving};
  }
  const Vec3 between = height * (rotation_ * face.normal);
  if (height >= reach_) return {between, (height - reach_) / moving};
  if (height < -depth_limit_) return {between, 0.0};
  const Vec3 normal = -(rotation_ * face.normal);
  if (is_near_normal_cone(ground_.features, ground_vertex, normal)) {
    contact =
        make_vertex_contact(ContactKind::kFaceVertex, block_face, ground_vertex, normal, height);
  }
  return {between, 0.0};
}

ContactPoint FeatureTests::make_vertex_contact(ContactKind kind, std::uint32_t block_feature,
                                               std::uint32_t ground_vertex, const Vec3& normal,
                                               double distance) const {
  ContactPoint contact;
  contact.kind = kind;
  contact.block_feature = block_feature;
  contact.ground_feature = ground_vertex;
  contact.ground_face = ground_.face_of_vertex[ground_vertex];
  contact.normal = normal;
  contact.overlap = reach_ - distance;
  contact.surface_point = ground_.features.vertices[ground_vertex] + ground_.radius * normal;
  return contact;
}

Vec3 FeatureTests::push_direction(const NearestPoint& nearest, const Vec3& centre) const {
  // On the surface and inside a face, the push direction is the normal. It is also the normal
  // beyond the border of a survey: the direction back to the border would point downwards if the
  // ground falls towards it.
  return nearest.within_face || nearest.distance > -1e-9 || is_on_border(ground_.features, nearest)
             ? nearest.normal
             : Vec3((nearest.point - centre) / -nearest.distance);
}

bool FeatureTests::pushes_through_block(std::uint32_t vertex, const Vec3& push) const {
  return ground_.is_block && push.dot(rotation_ * block_.vertex_normals[vertex]) > 0.0;
}

NearestPoint FeatureTests::nearest_valid_push_point(std::uint32_t vertex, const Vec3& centre,
                                                    const NearestPoint& nearest,
                                                    std::span<const LocalFaces::Face> faces) const {
  NearestPoint best = nearest;
  double distance = 1e300;
  for (const LocalFaces::Face& face : faces) {
    const double depth = face.offset - face.normal.dot(centre);
    if (depth < -kDepthRounding || depth > distance + kDepthRounding) continue;
    const NearestPoint candidate = nearest_point_on_face(ground_.features, face.face, centre);
    if (candidate.within_face && candidate.distance < 0.0 && -candidate.distance < distance &&
        !is_inverted_push(vertex, centre, candidate)) {
      distance = -candidate.distance;
      best = candidate;
    }
  }
  return best;
}

ContactPoint FeatureTests::make_inside_contact(std::uint32_t vertex, const Vec3& centre,
                                               const NearestPoint& nearest) const {
  ContactPoint contact;
  contact.block_feature = vertex;
  contact.ground_feature = contact.ground_face = nearest.face;
  contact.normal = push_direction(nearest, centre);
  const double height = contact.normal.dot(centre - nearest.point);
  contact.overlap = reach_ - height;
  contact.surface_point = centre + (ground_.radius - height) * contact.normal;
  return contact;
}

void FeatureTests::add_outside_contacts(std::uint32_t vertex, const Vec3& centre,
                                        std::span<const LocalFaces::Face> faces,
                                        std::vector<ContactPoint>& contacts) const {
  const SurfaceFeatures& ground = ground_.features;
  ContactPoint contact;
  contact.block_feature = vertex;
  const auto touch = [&](std::uint32_t face, const Vec3& on_ground, const Vec3& normal,
                         double distance) {
    contact.ground_feature = contact.ground_face = face;
    contact.normal = normal;
    contact.overlap = reach_ - distance;
    contact.surface_point = on_ground + ground_.radius * normal;
    add_unique_contact(contacts, contact);
  };
  for (const LocalFaces::Face& local : faces) {
    const double near = reach_ + local.radius;
    if ((centre - local.centre).squaredNorm() > near * near) continue;
    const std::uint32_t f = local.face;
    const SurfaceFace& face = ground.faces[f];
    const double height = face.normal.dot(centre - ground.vertices[face.vertices[0]]);
    if (std::abs(height) >= reach_) continue;
    if (height >= 0.0 && distance_inside_face(ground, face, centre) >= 0.0) {
      touch(f, centre - height * face.normal, face.normal, height);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const SurfaceEdge& edge = ground.edges[face.edges[k]];
      // Each edge is tested once. Near an edge sharper than a right angle, points outside can be
      // behind the planes of both faces; not so at a border.
      if (edge.faces[0] == f && edge.is_convex() &&
          (height >= 0.0 || edge.kind == EdgeKind::kConvex)) {
        const double along = edge.direction.dot(centre - ground.vertices[edge.vertices[0]]);
        if (along >= 0.0 && along <= edge.length) {
          const Vec3 on_edge = ground.vertices[edge.vertices[0]] + along * edge.direction;
          const Vec3 out = centre - on_edge;
          const double distance = out.norm();
          if (distance > 0.0 && distance < reach_) {
            const Vec3 normal = out / distance;
            if (is_in_normal_arc(ground, edge, normal) && can_vertex_touch(vertex, normal)) {
              touch(f, on_edge, normal, distance);
            }
          }
        }
      }
      const std::uint32_t ground_vertex = face.vertices[k];
      if (!ground.is_pointed_vertex[ground_vertex]) continue;
      const Vec3 out = centre - ground.vertices[ground_vertex];
      const double distance = out.norm();
      if (!(distance > 0.0 && distance < reach_)) continue;
      const Vec3 normal = out / distance;
      if (is_in_normal_cone(ground, ground_vertex, normal) && can_vertex_touch(vertex, normal)) {
        touch(f, ground.vertices[ground_vertex], normal, distance);
      }
    }
  }
}

}  // namespace clast::dem_detail

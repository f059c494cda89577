#include "dem/search/feature_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "dem/surface/ghost_edges.hpp"
#include "dem/surface/segment_distance.hpp"

namespace clast::dem_detail {
namespace {

/// Edge and face contacts deeper than this share of the smallest side are not trusted: beyond the
/// middle of the block the opposite side would be nearer.
constexpr double kDepthShare = 0.5;
/// Depths that differ by less are compared exactly, m.
constexpr double kDepthRounding = 1e-9;
/// A turn can make edges and faces touch that are deeper than anything that touches already: by
/// this share of that depth, and this many margins.
constexpr double kDeeperShare = 0.5, kDeeperMargins = 0.25;
/// What is allowed for is this much deeper, and given up again when it is this much too deep.
constexpr double kAllowedShare = 1.5, kTooDeepShare = 4.0;

}  // namespace

void add_once(std::vector<ContactPoint>& contacts, const ContactPoint& contact) {
  for (const ContactPoint& known : contacts) {
    const bool related =
        known.kind == contact.kind && (known.block_feature == contact.block_feature ||
                                       (known.kind != ContactKind::kVertexGround &&
                                        known.ground_feature == contact.ground_feature));
    if (related && known.normal.dot(contact.normal) > 1.0 - 1e-12 &&
        (known.foot - contact.foot).squaredNorm() < 1e-18) {
      return;
    }
  }
  contacts.push_back(contact);
}

bool AllowedDepth::update(double deepest, double margin) {
  const double needed =
      deepest > 0.0 ? (1.0 + kDeeperShare) * deepest + kDeeperMargins * margin : 0.0;
  const bool deeper = needed > depth_;
  if (deeper || kTooDeepShare * needed < depth_) depth_ = kAllowedShare * needed;
  return deeper;
}

FeatureContacts::FeatureContacts(const IndexedSurface& ground, const BlockSurface& block,
                                 double size)
    : ground_(ground),
      block_(block.features),
      reach_(block.radius + ground.radius),
      bounding_radius_(block.bounding_radius),
      depth_limit_(kDepthShare * size) {}

bool FeatureContacts::meets_vertex(std::uint32_t vertex, const Vec3& normal) const {
  return in_cone(block_, vertex, -(rotation_.transpose() * normal));
}

bool FeatureContacts::meets_edge(std::uint32_t edge, const Vec3& normal) const {
  return in_arc(block_, block_.edges[edge], -(rotation_.transpose() * normal));
}

bool FeatureContacts::edges_carry(const SurfaceEdge& of_ground, const SurfaceEdge& of_block,
                                  const Vec3& normal) const {
  const Vec3 in_body = -(rotation_.transpose() * normal);
  return near_arc(ground_.features, of_ground, normal) && near_arc(block_, of_block, in_body);
}

FeaturesApart FeatureContacts::edge_edge(std::uint32_t block_edge, std::uint32_t ground_edge,
                                         std::optional<ContactPoint>& contact) const {
  const SurfaceEdge& edge = block_.edges[block_edge];
  const SurfaceEdge& other = ground_.features.edges[ground_edge];
  const Segment of_block{placed(block_.vertices[edge.vertices[0]]), rotation_ * edge.direction,
                         edge.length};
  const Segment of_ground = ground_.features.segment(other);
  const ClosestOnSegments closest = closest_on_segments(of_block, of_ground);
  if (!closest.crossing) {
    return {closest.between,
            way_to_crossing(closest, of_block, of_ground, position_, bounding_radius_)};
  }
  Vec3 normal = of_block.direction.cross(other.direction);
  normal *= (normal.dot(ground_.features.edge_normal(other)) >= 0.0 ? 1.0 : -1.0) / normal.norm();
  const double gap = normal.dot(of_block.start - of_ground.start);
  if (gap >= reach_ || gap < -depth_limit_ || !edges_carry(other, edge, normal)) {
    return {closest.between, 0.0};
  }
  contact.emplace();
  contact->kind = ContactKind::kEdgeEdge;
  contact->block_feature = block_edge;
  contact->ground_feature = ground_edge;
  contact->ground_face = other.faces[0];
  contact->normal = normal;
  contact->overlap = reach_ - gap;
  contact->foot = of_ground.at(closest.second) + ground_.radius * normal;
  return {closest.between, 0.0};
}

FeaturesApart FeatureContacts::edge_corner(std::uint32_t block_edge, std::uint32_t ground_vertex,
                                           std::optional<ContactPoint>& contact) const {
  const SurfaceEdge& edge = block_.edges[block_edge];
  const Vec3& corner = ground_.features.vertices[ground_vertex];
  const Vec3 start = placed(block_.vertices[edge.vertices[0]]);
  const Vec3 along = rotation_ * edge.direction;
  const double s = along.dot(corner - start);
  const Vec3 out = start + std::clamp(s, 0.0, edge.length) * along - corner;
  const double distance = out.norm();
  const double beyond = std::max(-s, s - edge.length);
  if (distance >= reach_ || beyond >= 0.0 || !(distance > 0.0)) {
    return {out, std::max({0.0, distance - reach_, beyond / moving_as_seen(corner)})};
  }
  const Vec3 normal = out / distance;
  if (meets_edge(block_edge, normal) && in_cone(ground_.features, ground_vertex, normal)) {
    contact = at_corner(ContactKind::kEdgeVertex, block_edge, ground_vertex, normal, distance);
  }
  return {out, 0.0};
}

FeaturesApart FeatureContacts::face_corner(std::uint32_t block_face, std::uint32_t ground_vertex,
                                           std::optional<ContactPoint>& contact) const {
  const SurfaceFace& face = block_.faces[block_face];
  const Vec3& corner = ground_.features.vertices[ground_vertex];
  const Vec3 in_body = rotation_.transpose() * (corner - position_);
  const double height = face.normal.dot(in_body - block_.vertices[face.vertices[0]]);
  const double moving = moving_as_seen(corner);
  if (depth_in_face(block_, face, in_body) < 0.0) {
    const Vec3 between = in_body - nearest_on_face(block_, block_face, in_body).point;
    const double beside = std::sqrt(std::max(0.0, between.squaredNorm() - height * height));
    return {rotation_ * between, std::max(beside, height - reach_) / moving};
  }
  const Vec3 between = height * (rotation_ * face.normal);
  if (height >= reach_) return {between, (height - reach_) / moving};
  if (height < -depth_limit_) return {between, 0.0};
  const Vec3 normal = -(rotation_ * face.normal);
  if (near_cone(ground_.features, ground_vertex, normal)) {
    contact = at_corner(ContactKind::kFaceVertex, block_face, ground_vertex, normal, height);
  }
  return {between, 0.0};
}

ContactPoint FeatureContacts::at_corner(ContactKind kind, std::uint32_t block_feature,
                                        std::uint32_t ground_vertex, const Vec3& normal,
                                        double distance) const {
  ContactPoint contact;
  contact.kind = kind;
  contact.block_feature = block_feature;
  contact.ground_feature = ground_vertex;
  contact.ground_face = ground_.face_of_vertex[ground_vertex];
  contact.normal = normal;
  contact.overlap = reach_ - distance;
  contact.foot = ground_.features.vertices[ground_vertex] + ground_.radius * normal;
  return contact;
}

Vec3 FeatureContacts::push_of(const NearestPoint& nearest, const Vec3& centre) const {
  // On the surface itself, and above a face, the direction to it is its normal. So it is beyond the
  // border of a survey: the way back to the border would lead down where the ground falls to it.
  return nearest.within_face || nearest.distance > -1e-9 || on_border(ground_.features, nearest)
             ? nearest.normal
             : Vec3((nearest.point - centre) / -nearest.distance);
}

bool FeatureContacts::pushes_backwards(std::uint32_t vertex, const Vec3& push) const {
  return ground_.of_block && push.dot(rotation_ * block_.vertex_normals[vertex]) > 0.0;
}

NearestPoint FeatureContacts::nearest_forwards(std::uint32_t vertex, const Vec3& centre,
                                               const NearestPoint& nearest,
                                               std::span<const LocalFaces::Face> faces) const {
  NearestPoint best = nearest;
  double distance = 1e300;
  for (const LocalFaces::Face& face : faces) {
    const double depth = face.offset - face.normal.dot(centre);
    if (depth < -kDepthRounding || depth > distance + kDepthRounding) continue;
    const NearestPoint candidate = nearest_on_face(ground_.features, face.face, centre);
    if (candidate.within_face && candidate.distance < 0.0 && -candidate.distance < distance &&
        !is_backwards(vertex, centre, candidate)) {
      distance = -candidate.distance;
      best = candidate;
    }
  }
  return best;
}

ContactPoint FeatureContacts::inside(std::uint32_t vertex, const Vec3& centre,
                                     const NearestPoint& nearest) const {
  ContactPoint contact;
  contact.block_feature = vertex;
  contact.ground_feature = contact.ground_face = nearest.face;
  contact.normal = push_of(nearest, centre);
  const double height = contact.normal.dot(centre - nearest.point);
  contact.overlap = reach_ - height;
  contact.foot = centre + (ground_.radius - height) * contact.normal;
  return contact;
}

void FeatureContacts::add_outside(std::uint32_t vertex, const Vec3& centre,
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
    contact.foot = on_ground + ground_.radius * normal;
    add_once(contacts, contact);
  };
  for (const LocalFaces::Face& local : faces) {
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

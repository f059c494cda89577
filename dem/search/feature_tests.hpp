#pragma once
/// Exact tests of a feature of a block with one of its ground, the terrain or another block: how
/// far they are apart, and where they touch. The searches (`TerrainNarrowPhase`,
/// `BlockNarrowPhase`) choose which features are worth a test. Everything is in the frame of the
/// ground.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem/surface/block_surface.hpp"
#include "dem/surface/local_ground.hpp"

namespace clast::dem_detail {

enum class ContactKind : std::uint8_t {
  kVertexGround,  ///< block vertex against a face, edge or vertex of the ground
  kEdgeEdge,
  kEdgeVertex,  ///< block edge against a ground vertex
  kFaceVertex,  ///< block face against a ground vertex
};

/// A feature of the block and one of its ground.
struct FeatureSeparation {
  Vec3 separation = Vec3::Zero();  ///< from the nearest point of the ground's to the block's, m
  /// No contact of the two, however deep, before the block has moved so far, m: the shift of its
  /// centre and its bounding radius times the chord of its turn together. 0 where that is not
  /// known.
  double safe_displacement = 0.0;
};

/// One point where the rounded block overlaps the ground's skin.
struct ContactPoint {
  ContactKind kind = ContactKind::kVertexGround;
  std::uint32_t block_feature = 0;    ///< vertex, edge or face of the block
  std::uint32_t ground_feature = 0;   ///< edge or vertex of the ground; a face for kVertexGround
  std::uint32_t ground_face = 0;      ///< a face next to the contact: gives the zone
  Vec3 normal = Vec3::UnitZ();        ///< unit, out of the ground into the block
  Vec3 surface_point = Vec3::Zero();  ///< on the ground's skin
  double overlap = 0.0;               ///< m, positive

  /// Middle of the overlap: where forces act.
  Vec3 position() const { return surface_point - 0.5 * overlap * normal; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(kind, block_feature, ground_feature, ground_face, normal, surface_point, overlap);
  }
};

/// Adds a contact unless it is known: a point on the border between two faces of one plane, or at
/// the joint of two collinear edges, is found twice but is one contact.
void add_unique(std::vector<ContactPoint>& contacts, const ContactPoint& contact);

/// How deep contacts of edges and faces may be by now: a turn can make some touch that are deeper
/// than anything that touches already.
class ContactDepthLimit {
 public:
  /// @param deepest  of the present contacts, m; 0 without any
  /// @param margin   how far lists look ahead, m
  /// @return  true when what was left out before has not allowed for this depth
  bool update(double deepest, double margin);
  void reset(double depth = 0.0) { depth_ = depth; }
  double depth() const { return depth_; }  ///< m
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(depth_);
  }

 private:
  double depth_ = 0.0;
};

class FeatureTests {
 public:
  /// @param size  smallest side, m: edges and faces are not trusted to touch deeper than half of it
  FeatureTests(const IndexedSurface& ground, const BlockSurface& block, double size);

  void set_pose(const Mat3& rotation, const Vec3& position) {
    rotation_ = rotation;
    position_ = position;
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(rotation_, position_);
  }
  const Mat3& rotation() const { return rotation_; }
  const Vec3& position() const { return position_; }
  double reach() const { return reach_; }  ///< block radius + skin radius, m
  /// A point of the body in the frame of the ground.
  Vec3 in_ground_frame(const Vec3& in_body) const { return position_ + rotation_ * in_body; }

  // Each sets the contact if there is one, and returns how far the two are apart.

  /// By kind, which is not kVertexGround.
  FeatureSeparation test_pair(ContactKind kind, std::uint32_t of_block, std::uint32_t of_ground,
                              std::optional<ContactPoint>& contact) const {
    return kind == ContactKind::kEdgeEdge     ? test_edge_edge(of_block, of_ground, contact)
           : kind == ContactKind::kEdgeVertex ? test_edge_vertex(of_block, of_ground, contact)
                                              : test_face_vertex(of_block, of_ground, contact);
  }
  FeatureSeparation test_edge_edge(std::uint32_t block_edge, std::uint32_t ground_edge,
                                   std::optional<ContactPoint>& contact) const;
  FeatureSeparation test_edge_vertex(std::uint32_t block_edge, std::uint32_t ground_vertex,
                                     std::optional<ContactPoint>& contact) const;
  FeatureSeparation test_face_vertex(std::uint32_t block_face, std::uint32_t ground_vertex,
                                     std::optional<ContactPoint>& contact) const;

  // A vertex of the block at `centre`, inside the ground or within reach of it.

  /// True when the way out of the ground would drag the vertex out through the block: beside the
  /// edge of a ground that ends where the block does, the nearest way out may be the ground's wall.
  /// @param nearest  to the vertex, which is inside
  bool is_inverted(std::uint32_t vertex, const Vec3& centre, const NearestPoint& nearest) const {
    return pushes_through_block(vertex, push_direction(nearest, centre));
  }
  bool pushes_through_block(std::uint32_t vertex, const Vec3& push) const;
  /// The nearest of these faces below which it lies that does not, or `nearest` where there is
  /// none.
  NearestPoint nearest_uninverted(std::uint32_t vertex, const Vec3& centre,
                                  const NearestPoint& nearest,
                                  std::span<const LocalFaces::Face> faces) const;
  /// The contact of a vertex inside the ground.
  ContactPoint inside_contact(std::uint32_t vertex, const Vec3& centre,
                              const NearestPoint& nearest) const;
  /// Adds those of a vertex within reach outside it.
  /// @param faces  all that are within reach of it, in order of their numbers
  void add_outside_contacts(std::uint32_t vertex, const Vec3& centre,
                            std::span<const LocalFaces::Face> faces,
                            std::vector<ContactPoint>& contacts) const;

 private:
  /// Seen from the block, a point of the ground moves up to this many times as far as the block:
  /// farther where it is beyond the bounding radius.
  double relative_motion_factor(const Vec3& point) const {
    return std::max(1.0, (point - position_).norm() / bounding_radius_);
  }
  ContactPoint vertex_contact(ContactKind kind, std::uint32_t block_feature,
                              std::uint32_t ground_vertex, const Vec3& normal,
                              double distance) const;
  /// Direction in which a vertex inside the ground is pushed: to the surface point, or up to the
  /// plane in which a ground that ends there goes on.
  Vec3 push_direction(const NearestPoint& nearest, const Vec3& centre) const;
  /// True when the block's own surface falls away from a ground that it touches along `normal`
  /// (out of the ground) with this vertex or edge.
  bool can_vertex_touch(std::uint32_t vertex, const Vec3& normal) const;
  bool can_edge_touch(std::uint32_t edge, const Vec3& normal) const;
  /// True when an edge of the ground and one of the block may carry along `normal`.
  bool can_edges_touch(const SurfaceEdge& of_ground, const SurfaceEdge& of_block,
                       const Vec3& normal) const;

  const IndexedSurface& ground_;
  const SurfaceFeatures& block_;
  double reach_;
  double bounding_radius_;  ///< of the block
  double depth_limit_;      ///< edge and face contacts deeper than this are not trusted, m
  Mat3 rotation_ = Mat3::Identity();
  Vec3 position_ = Vec3::Zero();
};

}  // namespace clast::dem_detail

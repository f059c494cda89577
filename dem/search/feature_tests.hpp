#pragma once
/// Exact distance and contact tests between a feature (vertex, edge or face) of a block and a
/// feature of the ground. The ground is the terrain or another block; all data are in its frame.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem/surface/block_surface.hpp"
#include "dem/surface/local_ground.hpp"

namespace clast::dem_detail {

enum class ContactKind : std::uint8_t {
  kVertexGround,  ///< block vertex and a ground face, edge or vertex
  kEdgeEdge,
  kEdgeVertex,  ///< block edge and a ground vertex
  kFaceVertex,  ///< block face and a ground vertex
};

/// Separation of a block feature and a ground feature.
struct FeatureSeparation {
  Vec3 separation = Vec3::Zero();  ///< from the nearest ground point to the nearest block point, m
  /// Displacement of the block for which contact is still impossible, m; 0 if unknown. A rotation
  /// by `angle` counts as 2 sin(angle/2) times the bounding radius.
  double contact_free_displacement = 0.0;
};

/// Contact point of a rounded block and the rounded ground surface.
struct ContactPoint {
  ContactKind kind = ContactKind::kVertexGround;
  std::uint32_t block_feature = 0;  ///< index of the vertex, edge or face of the block
  /// Index of the edge or vertex of the ground, or of the face for kVertexGround.
  std::uint32_t ground_feature = 0;
  std::uint32_t ground_face = 0;  ///< index of an adjacent ground face, which gives the ground zone
  Vec3 normal = Vec3::UnitZ();    ///< unit, out of the ground into the block
  Vec3 surface_point = Vec3::Zero();  ///< point on the rounded ground surface
  double overlap = 0.0;               ///< penetration depth, m, positive

  /// Returns the midpoint of the overlap, where forces act.
  Vec3 position() const { return surface_point - 0.5 * overlap * normal; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(kind, block_feature, ground_feature, ground_face, normal, surface_point, overlap);
  }
};

/// Adds a contact unless the list has it already. A point between two coplanar faces or collinear
/// edges is found twice.
void add_unique_contact(std::vector<ContactPoint>& contacts, const ContactPoint& contact);

/// Depth limit of the search for edge and face contacts. It exceeds the overlap of the present
/// contacts, because other contacts can become deeper when the block rotates.
class ContactDepthLimit {
 public:
  /// Updates the depth limit.
  /// @param deepest  largest overlap of the present contacts, m; 0 without contacts
  /// @param margin  distance before contact at which the narrow phase lists features, m
  /// @return true if the limit has grown, so that pairs excluded before must be tested again
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
  /// Prepares the distance and contact tests between features of a block and of the ground.
  /// @param size  smallest side of the smaller body, m; edge and face contacts deeper than half of
  ///              it are ignored
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
  double reach() const { return reach_; }  ///< sum of the rounding radii of block and ground, m
  /// Transforms a point from the body frame of the block to the frame of the ground.
  Vec3 in_ground_frame(const Vec3& in_body) const { return position_ + rotation_ * in_body; }

  // Each function sets `contact` if the two features touch, and returns their separation.

  /// Tests a block feature and a ground feature for contact. `kind` must not be kVertexGround.
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

  // The vertex at `centre` is inside the ground or within reach of it.

  /// True if the contact of a vertex inside the ground is inverted: pushing it out along the
  /// shortest way would move it through its own block.
  /// @param nearest  ground point nearest to the vertex, which is inside the ground
  bool is_inverted_push(std::uint32_t vertex, const Vec3& centre,
                        const NearestPoint& nearest) const {
    return pushes_through_block(vertex, push_direction(nearest, centre));
  }
  bool pushes_through_block(std::uint32_t vertex, const Vec3& push) const;
  /// Returns the nearest ground point to which the vertex can be pushed without passing through its
  /// own block; `nearest` if there is none.
  NearestPoint nearest_valid_push_point(std::uint32_t vertex, const Vec3& centre,
                                        const NearestPoint& nearest,
                                        std::span<const LocalFaces::Face> faces) const;
  /// Makes the contact of a vertex inside the ground.
  ContactPoint make_inside_contact(std::uint32_t vertex, const Vec3& centre,
                                   const NearestPoint& nearest) const;
  /// Adds the contacts of a vertex that is outside the ground but closer than the rounding radii.
  /// @param faces  all faces within reach, in index order
  void add_outside_contacts(std::uint32_t vertex, const Vec3& centre,
                            std::span<const LocalFaces::Face> faces,
                            std::vector<ContactPoint>& contacts) const;

 private:
  /// Returns an upper bound of the displacement of a ground point in the frame of the block, as a
  /// multiple of the block's displacement.
  double relative_motion_factor(const Vec3& point) const {
    return std::max(1.0, (point - position_).norm() / bounding_radius_);
  }
  ContactPoint make_vertex_contact(ContactKind kind, std::uint32_t block_feature,
                                   std::uint32_t ground_vertex, const Vec3& normal,
                                   double distance) const;
  /// Returns the direction in which a vertex inside the ground is pushed out: towards the nearest
  /// ground point, or along the normal at a border of the ground.
  Vec3 push_direction(const NearestPoint& nearest, const Vec3& centre) const;
  /// True if the vertex of the block can touch the ground along its outward `normal`.
  bool can_vertex_touch(std::uint32_t vertex, const Vec3& normal) const;
  bool can_edge_touch(std::uint32_t edge, const Vec3& normal) const;
  /// True if a ground edge and a block edge can be in contact along `normal`.
  bool can_edges_touch(const SurfaceEdge& of_ground, const SurfaceEdge& of_block,
                       const Vec3& normal) const;

  const IndexedSurface& ground_;
  const SurfaceFeatures& block_;
  double reach_;
  double bounding_radius_;  ///< bounding radius of the block, m
  double depth_limit_;      ///< depth limit of edge and face contacts, m
  Mat3 rotation_ = Mat3::Identity();
  Vec3 position_ = Vec3::Zero();
};

}  // namespace clast::dem_detail

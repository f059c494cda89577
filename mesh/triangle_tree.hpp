#pragma once
/// Bounding-volume tree of a triangle mesh for closest points and ray queries.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Tree over a mesh, which must outlive it.
class TriangleTree {
 public:
  /// Builds the tree.
  /// @param mesh  not empty; for signed distances also closed, with outward normals
  explicit TriangleTree(const TriangleMesh& mesh);

  struct Closest {
    Vec3 point = Vec3::Zero();
    double squared_distance = 0.0;
    std::uint32_t triangle = 0;
    int feature = 0;  ///< 0: the face; 1 to 3: vertex 0 to 2; 4 to 6: side 0 to 2
  };
  /// Returns the closest point of the mesh.
  /// The lowest index is returned of several triangles that are equally near.
  /// @param hint  index of a triangle that is probably near; affects only the speed
  Closest closest_point(const Vec3& point, std::uint32_t hint = 0) const;

  double distance_to(std::uint32_t triangle, const Vec3& point) const;
  const Vec3& first_vertex(std::uint32_t triangle) const {
    return mesh_.vertices[mesh_.triangles[triangle][0]];
  }
  const Vec3& face_normal(std::uint32_t triangle) const { return face_normals_[triangle]; }
  /// Returns the unit outward normal of a face, vertex or side, as numbered by `Closest::feature`.
  /// That of a vertex is weighted by angles.
  Vec3 outward_normal(std::uint32_t triangle, int feature) const {
    return feature_normal(triangle, feature).normalized();
  }

  /// False if no part of the surface within `radius` of `centre` is above the plane
  /// normal . x = height. It may be true if only parts a little farther away are.
  bool has_point_above(const Vec3& normal, double height, const Vec3& centre, double radius) const;

  /// Returns the signed distance, negative inside. The sign follows from the angle-weighted normal
  /// of the closest face, edge or vertex.
  /// @cite baerentzen2005
  double signed_distance(const Vec3& point, std::uint32_t hint = 0) const;

  struct SignedClosest {
    Vec3 foot = Vec3::Zero();      ///< closest point of the surface
    double distance = 0.0;         ///< negative inside
    Vec3 outward = Vec3::UnitX();  ///< unit gradient of the distance
    std::uint32_t triangle = 0;
    Vec3 weights = Vec3::Zero();  ///< barycentric coordinates of `foot`
  };
  /// Returns the closest point with signed distance and gradient.
  SignedClosest signed_closest_point(const Vec3& point, std::uint32_t hint = 0) const;

  struct RayHit {
    double distance;
    std::uint32_t triangle;
  };
  /// Returns the first triangle through which the ray from `origin` along `direction` (unit) leaves
  /// the solid. The triangle `ignored` is skipped.
  std::optional<RayHit> first_exit(const Vec3& origin, const Vec3& direction,
                                   std::uint32_t ignored) const;

 private:
  /// Four bounding boxes, of single triangles or of nodes. They are in single precision, relative
  /// to `origin_`, and rounded outwards.
  struct Node {
    Eigen::Array<float, 4, 3> low, high;
    std::array<std::uint32_t, 4> children;  ///< index of a node, `kLeaf` + place of a triangle, or
                                            ///< `kNone`
  };
  /// A triangle in the order of the tree.
  struct Corners {
    Vec3 a, b, c;
    std::uint32_t triangle;
  };
  static constexpr std::uint32_t kLeaf = 0x80000000u, kNone = 0xffffffffu;

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  void set_box(Node& node, int child, std::uint32_t begin, std::uint32_t end) const;
  void prepare_normals();
  const Vec3& feature_normal(std::uint32_t triangle, int feature) const;

  const TriangleMesh& mesh_;
  Vec3 origin_;
  double extent_;  ///< largest coordinate relative to `origin_`
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Corners> corners_;
  std::vector<Vec3> face_normals_, vertex_normals_;
  std::vector<std::array<Vec3, 3>> side_normals_;
};

}  // namespace clast

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
  /// @param hint  index of a triangle that is probably near; affects only the speed
  Closest closest_point(const Vec3& point, std::uint32_t hint = 0) const;

  double distance_to(std::uint32_t triangle, const Vec3& point) const;
  const Vec3& first_vertex(std::uint32_t triangle) const {
    return mesh_.vertices[mesh_.triangles[triangle][0]];
  }
  const Vec3& face_normal(std::uint32_t triangle) const { return face_normals_[triangle]; }

  /// True if some triangle near `centre` reaches above the plane normal . x = height. A triangle is
  /// near if its bounding box is partly within `radius`.
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
  const Vec3& feature_normal(const Closest& found) const;
  struct Node {
    Bounds box;
    std::uint32_t first = 0, count = 0;  ///< leaf: range of triangles; inner node: count 0
    std::uint32_t right = 0;  ///< inner node: right child; the left child follows its parent
  };
  void build(std::uint32_t begin, std::uint32_t end);
  void prepare_normals();

  const TriangleMesh& mesh_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Vec3> face_normals_, vertex_normals_;
  std::vector<std::array<Vec3, 3>> side_normals_;
};

}  // namespace clast

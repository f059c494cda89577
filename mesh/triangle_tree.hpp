#pragma once
/// Closest points on a triangle mesh, and what a ray meets, through a tree of boxes.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Keeps a reference to the mesh, which must stay.
class TriangleTree {
 public:
  /// @param mesh  at least one triangle; for `signed_distance` closed and outward
  explicit TriangleTree(const TriangleMesh& mesh);

  struct Closest {
    Vec3 point = Vec3::Zero();
    double squared_distance = 0.0;
    std::uint32_t triangle = 0;
    int feature = 0;  ///< 0: inside the triangle, 1..3: at corner k - 1, 4..6: on side k - 4
  };
  /// @param hint  a triangle that is likely near; makes the search shorter and changes nothing else
  Closest closest_point(const Vec3& point, std::uint32_t hint = 0) const;

  double distance_to(std::uint32_t triangle, const Vec3& point) const;
  const Vec3& first_vertex(std::uint32_t triangle) const {  ///< the first
    return mesh_.vertices[mesh_.triangles[triangle][0]];
  }
  const Vec3& face_normal(std::uint32_t triangle) const { return face_normals_[triangle]; }

  /// Does anything of the surface within `radius` of `centre` rise above the plane
  /// normal.x = height? Triangles count whole where a part of their box is that near.
  bool has_point_above(const Vec3& normal, double height, const Vec3& centre, double radius) const;

  /// Distance to the surface, negative inside: the side is told by the angle-weighted normal of
  /// the face, edge or vertex that is closest.
  /// @cite baerentzen2005
  double signed_distance(const Vec3& point, std::uint32_t hint = 0) const;

  struct SignedClosest {
    Vec3 foot = Vec3::Zero();      ///< closest point of the surface
    double distance = 0.0;         ///< negative inside
    Vec3 outward = Vec3::UnitX();  ///< unit gradient of the distance
    std::uint32_t triangle = 0;
    Vec3 weights = Vec3::Zero();  ///< of the triangle's corners, that make `foot`
  };
  /// All about the closest point.
  SignedClosest signed_closest_point(const Vec3& point, std::uint32_t hint = 0) const;

  struct RayHit {
    double distance;
    std::uint32_t triangle;
  };
  /// First triangle that the ray from `origin` along `direction` (unit) meets from inside, that is
  /// one that faces along the ray, other than `ignored`.
  std::optional<RayHit> first_exit(const Vec3& origin, const Vec3& direction,
                                   std::uint32_t ignored) const;

 private:
  const Vec3& feature_normal(const Closest& found) const;
  struct Node {
    Bounds box;
    std::uint32_t first = 0, count = 0;  ///< leaf: triangles; inner: count 0
    std::uint32_t right = 0;             ///< inner: the left child follows its parent
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

#pragma once
/// Ground near a block, copied to contiguous memory for fast queries.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "dem/surface/indexed_surface.hpp"

namespace clast::dem_detail {

/// Plane above all ground of a region, which gives lower bounds of the distance to the ground.
struct BoundingPlane {
  Vec3 normal = Vec3::UnitZ();  ///< unit normal: mean of the face normals
  double offset = -1e300;       ///< largest projection of a ground point onto `normal`, m

  /// Returns a lower bound of the distance of a point from the ground, m; it is not valid if
  /// negative.
  double clearance(const Vec3& point) const { return normal.dot(point) - offset; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(normal, offset);
  }
};
/// Prism over and under a ground face: the plane of the face, and the planes through its edges
/// perpendicular to it.
struct FacePrism {
  double normal[3];  ///< unit normal of the face, out of the ground
  double offset;     ///< offset of the plane of the face: normal.dot(point) of its points, m
  /// Unit normals of the planes through the edges, towards the face, and their offsets, m. All are
  /// zero for a face at a border: the ground continues there as a plane, which has no edges.
  double inward[3][3];
  double inward_offset[3];

  /// Returns the height of a point over the plane of the face, m.
  double height(const Vec3& point) const { return distance(normal, offset, point); }
  /// Returns the distance from the prism of a point outside it, m, or a smaller value; negative
  /// inside; 0 for a face at a border.
  double distance_beside(const Vec3& point) const {
    return -std::min({distance(inward[0], inward_offset[0], point),
                      distance(inward[1], inward_offset[1], point),
                      distance(inward[2], inward_offset[2], point)});
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(offset);
    for (int k = 0; k < 3; ++k) {
      bytes(normal[k], inward[k][0], inward[k][1], inward[k][2], inward_offset[k]);
    }
  }

 private:
  static double distance(const double* normal, double offset, const Vec3& point) {
    return normal[0] * point.x() + normal[1] * point.y() + normal[2] * point.z() - offset;
  }
};
/// True if the face is at a border of the ground.
bool is_at_border(const SurfaceFeatures& features, std::uint32_t face);
FacePrism make_face_prism(const SurfaceFeatures& features, std::uint32_t face);

struct LocalFaces {
  struct Face {
    Vec3 normal;
    double offset;  ///< plane offset: a point is normal.dot(point) - offset above the plane, m
    Vec3 centre;    ///< centre of a bounding sphere with `radius`
    double radius;
    std::uint32_t face;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(normal, offset, centre, radius, face);
    }
  };
  std::vector<Face> faces;
  std::vector<FacePrism> prisms;  ///< prisms over `faces`
  BoundingPlane plane;            ///< plane above all faces

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(faces, prisms, plane);
  }

  /// Copies the faces of `from` within the distance `reach` of a point, in the same order.
  void collect_near(const SurfaceFeatures& features, const LocalFaces& from, const Vec3& centre,
                    double reach);

  struct NearestFace {
    NearestPoint nearest;  ///< nearest point; its distance is 1e300 if no face is within the limit
    double second = 0.0;   ///< lower bound of the distance of all other faces, m
    std::uint32_t entry = 0;  ///< index into `faces`
  };
  /// Finds the point of the listed faces that is nearest to `query`, within `limit` (m). Other
  /// faces are measured up to `beyond` (m) farther. `guess` is a probable index, for speed.
  NearestFace nearest(const SurfaceFeatures& features, const Vec3& query, double limit,
                      double beyond, std::uint32_t guess) const;

 protected:
  void fit_bounding_plane(const SurfaceFeatures& features);
};

/// Ground features near a block, ordered by index.
struct LocalGround : LocalFaces {
  std::vector<std::uint32_t> edges;  ///< indices of convex edges
  std::vector<std::uint32_t> pointed_vertices;

  template <class Bytes>
  void serialize(Bytes& bytes) {
    LocalFaces::serialize(bytes);
    bytes(edges, pointed_vertices);
  }

  /// Copies all ground features within the distance `reach` of a point.
  void collect_near(const IndexedSurface& ground, const Vec3& centre, double reach);
};

/// Makes the list entry of a face, with precomputed plane and bounding sphere.
LocalFaces::Face make_local_face(const SurfaceFeatures& features, std::uint32_t face);

/// Finds the point of the given faces that is nearest to `query`.
/// @param limit  largest distance, m; farther faces are ignored
/// @param beyond  distance beyond the nearest face up to which other faces are measured, m
/// @param guess  index of a face in the list that is probably near; affects only the speed
LocalFaces::NearestFace find_nearest_face(std::span<const LocalFaces::Face> faces,
                                          const SurfaceFeatures& features, const Vec3& query,
                                          double limit, double beyond, std::uint32_t guess);

}  // namespace clast::dem_detail

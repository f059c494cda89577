#pragma once
/// The ground near a block, its faces copied together so that many queries read little memory.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/surface/indexed_surface.hpp"

namespace clast::dem_detail {

/// A plane that no ground of some region rises above: bounds the distance to all of it at once.
struct BoundingPlane {
  Vec3 normal = Vec3::UnitZ();  ///< mean of the faces' normals
  double offset = -1e300;       ///< largest normal . point on the ground, m

  /// Lower bound of the distance of a point over the ground; negative when it gives none.
  double clearance(const Vec3& point) const { return normal.dot(point) - offset; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(normal, offset);
  }
};
/// Some faces of the ground.
struct LocalFaces {
  struct Face {
    Vec3 normal;
    double offset;  ///< height of a point over the plane: normal . point - offset
    Vec3 centre;    ///< with `radius`, a ball around the face
    double radius;
    std::uint32_t face;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(normal, offset, centre, radius, face);
    }
  };
  std::vector<Face> faces;
  BoundingPlane plane;  ///< over all of them

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(faces, plane);
  }

  /// Takes those of `from` within `reach` of the point, in their order.
  void collect_near(const SurfaceFeatures& features, const LocalFaces& from, const Vec3& centre,
                    double reach);

  struct NearestFace {
    NearestPoint nearest;     ///< distance 1e300 when nothing is within the limit
    double second = 0.0;      ///< all other faces are at least this far, m
    std::uint32_t entry = 0;  ///< of `faces`
  };
  /// As `find_nearest_face` all its faces.
  NearestFace nearest(const SurfaceFeatures& features, const Vec3& query, double limit,
                      double beyond, std::uint32_t guess) const;

 protected:
  void fit_bounding_plane(const SurfaceFeatures& features);
};

/// All of the ground near a block, ordered by number.
struct LocalGround : LocalFaces {
  std::vector<std::uint32_t> edges;             ///< convex ones
  std::vector<std::uint32_t> pointed_vertices;  ///< pointed vertices

  template <class Bytes>
  void serialize(Bytes& bytes) {
    LocalFaces::serialize(bytes);
    bytes(edges, pointed_vertices);
  }

  /// Gathers everything within `reach` of the point.
  void collect_near(const IndexedSurface& ground, const Vec3& centre, double reach);
};

/// A face as lists of the ground hold it.
LocalFaces::Face make_local_face(const SurfaceFeatures& features, std::uint32_t face);

/// Nearest point of some faces of a surface to `query`.
/// @param limit   m: what is farther does not matter
/// @param beyond  m: how much farther than the nearest other faces are measured
/// @param guess   entry of a face that may be near: the answer is the same, but sooner found
LocalFaces::NearestFace find_nearest_face(std::span<const LocalFaces::Face> faces,
                                          const SurfaceFeatures& features, const Vec3& query,
                                          double limit, double beyond, std::uint32_t guess);

}  // namespace clast::dem_detail

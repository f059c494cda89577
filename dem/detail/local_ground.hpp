#pragma once
/// The ground near a part of a block, copied together so that many queries read little memory.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/detail/indexed_surface.hpp"

namespace clast::dem_detail {

/// A plane that no ground of some region rises above: bounds the distance to all of it at once.
struct GroundPlane {
  Vec3 normal = Vec3::UnitZ();  ///< mean of the faces' normals
  double top = -1e300;          ///< largest normal . point on the ground, m

  /// Lower bound of the distance of a point over the ground; negative when it gives none.
  double clearance(const Vec3& point) const { return normal.dot(point) - top; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(normal, top);
  }
};
struct LocalGround {
  struct Face {
    Vec3 normal;
    double offset;  ///< height of a point over the plane: normal . point - offset
    Vec3 middle;    ///< with `radius`, a ball around the face
    double radius;
    std::uint32_t face;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(normal, offset, middle, radius, face);
    }
  };
  struct Edge {
    Vec3 start, direction;
    double length;
    std::uint32_t edge;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(start, direction, length, edge);
    }
  };
  struct Corner {
    Vec3 point;
    std::uint32_t vertex;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(point, vertex);
    }
  };
  std::vector<Face> faces;
  std::vector<Edge> edges;      ///< convex ones
  std::vector<Corner> corners;  ///< pointed ones
  GroundPlane plane;            ///< over all of it

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(faces, edges, corners, plane);
  }

  /// Gathers everything within `reach` of the point, from the whole ground or from what was
  /// gathered before. Ordered by number.
  void gather(const IndexedSurface& ground, const Vec3& centre, double reach);
  void gather(const SurfaceFeatures& features, const LocalGround& from, const Vec3& centre,
              double reach);

  struct Nearest {
    NearestPoint nearest;     ///< distance 1e300 when nothing is within the limit
    double second = 0.0;      ///< all other faces are at least this far, m
    std::uint32_t entry = 0;  ///< of `faces`
  };
  /// As `nearest_of` all its faces.
  Nearest nearest(const SurfaceFeatures& features, const Vec3& query, double limit, double beyond,
                  std::uint32_t guess) const;

 private:
  void fit_plane(const SurfaceFeatures& features);
};

/// A face as lists of the ground hold it.
LocalGround::Face local_face(const SurfaceFeatures& features, std::uint32_t face);

/// Nearest point of some faces of a surface to `query`.
/// @param limit   m: what is farther does not matter
/// @param beyond  m: how much farther than the nearest other faces are measured
/// @param guess   entry of a face that may be near: the answer is the same, but sooner found
LocalGround::Nearest nearest_of(std::span<const LocalGround::Face> faces,
                                const SurfaceFeatures& features, const Vec3& query, double limit,
                                double beyond, std::uint32_t guess);

}  // namespace clast::dem_detail

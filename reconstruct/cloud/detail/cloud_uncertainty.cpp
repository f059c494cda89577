#include "reconstruct/cloud/detail/cloud_uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/local_surface.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr int kMarginNeighbours = 40;  ///< whose planes bound a point's surroundings
/// A tip is no longer than this, in spacings: of a slender one few points would lie on that length.
constexpr double kFarthestTip = 8.0;
constexpr double kMaxOut = 3.0;       ///< spacings by which noise makes a point stand out at most
constexpr double kAlong = 0.05;       ///< a plane bounds directions that rise this steeply to it
constexpr double kPlaneLeeway = 3.0;  ///< scatters by which a plane lies farther out than fitted
constexpr double kStandsOut = 1.0;    ///< ... and by which a point may stand out of its neighbours
constexpr double kNoise = 1.0;        ///< standard deviations of the noise by which places are off

class Margin {
 public:
  Margin(const TriangleMesh& surface, const SurfacePointStatistics& known)
      : surface_(surface),
        known_(known),
        tree_(surface.vertices),
        standings_(MovingLeastSquares(surface.vertices, known.normals).plane_deviations()),
        near_(surface.vertices.size()) {}

  SurfaceUncertainty run() {
    std::vector<bool> used(surface_.vertices.size(), false);
    for (const TriangleMesh::Triangle& t : surface_.triangles) {
      add_triangle(t);
      for (const std::uint32_t v : t) used[v] = true;
    }
    for (std::uint32_t v = 0; v < used.size(); ++v) {
      if (used[v]) add_vertex(v);
    }
    return std::move(margin_);
  }

 private:
  /// Points around a vertex.
  const std::vector<std::uint32_t>& near(std::uint32_t v) {
    if (near_[v].empty()) {
      for (const PointTree::Neighbour& n :
           tree_.nearest_neighbours(surface_.vertices[v], kMarginNeighbours)) {
        near_[v].push_back(n.point);
      }
    }
    return near_[v];
  }

  /// Returns the distance from a position to the first plane of the surroundings. A plane that the
  /// position is already beyond is no bound, because its normal mixes points of two sides.
  /// @param v  the vertex whose surroundings these are
  double reach(const Vec3& from, const Vec3& direction, std::uint32_t v) {
    double reach = kFarthestTip * known_.spacings[v];
    for (const std::uint32_t n : near(v)) {
      const Vec3& normal = known_.normals[n];
      const double along = normal.dot(direction);
      if (along < kAlong) continue;
      const double room =
          kPlaneLeeway * standings_[n].deviation - normal.dot(from - surface_.vertices[n]);
      if (room >= 0.0) reach = std::min(reach, room / along);
    }
    return reach;
  }

  /// A triangle cuts across an edge or a tip between its corners.
  void add_triangle(const TriangleMesh::Triangle& t) {
    const Vec3 &a = surface_.vertices[t[0]], &b = surface_.vertices[t[1]],
               &c = surface_.vertices[t[2]];
    const Vec3 normal = (b - a).cross(c - a).normalized(), middle = (a + b + c) / 3.0;
    margin_.outer_points.push_back(middle + reach(middle, normal, t[0]) * normal);
  }

  void add_vertex(std::uint32_t v) {
    const Vec3& position = surface_.vertices[v];
    const Vec3& normal = known_.normals[v];
    const double noise = kNoise * known_.noise;
    margin_.outer_points.push_back(position + noise * normal);
    // At the edge of a side, the neighbours of a point lie to one side of it.
    Vec3 away = Vec3::Zero();
    for (const std::uint32_t n : near(v)) away += position - surface_.vertices[n];
    if (const double length = away.norm(); length > 0.0) {
      away /= length;
      margin_.outer_points.push_back(position + (reach(position, away, v) + noise) * away);
    }
    const MovingLeastSquares::PlaneDeviation& standing = standings_[v];
    const double out_of = standing.height - kStandsOut * standing.deviation;
    const double stands_out = std::clamp(out_of, 0.0, kMaxOut * known_.spacings[v]);
    margin_.inner_points.push_back(position - (stands_out + noise) * normal);
  }

  const TriangleMesh& surface_;
  const SurfacePointStatistics& known_;
  PointTree tree_;
  std::vector<MovingLeastSquares::PlaneDeviation> standings_;
  std::vector<std::vector<std::uint32_t>> near_;  ///< of vertices, as they are asked for
  SurfaceUncertainty margin_;
};

}  // namespace

SurfaceUncertainty compute_surface_uncertainty(const TriangleMesh& surface,
                                               const SurfacePointStatistics& points) {
  return Margin(surface, points).run();
}

}  // namespace clast::reconstruct_detail

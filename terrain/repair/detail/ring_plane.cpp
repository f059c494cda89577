#include "terrain/repair/detail/ring_plane.hpp"

namespace clast::terrain_detail {

std::optional<NeighbourPlane> fit_neighbour_plane(const TriangleMesh& mesh,
                                                  std::span<const std::uint32_t> ring,
                                                  std::uint32_t vertex) {
  if (ring.size() < 3) return std::nullopt;
  const Vec3& centre = mesh.vertices[vertex];
  // Not the vertex's own height: that of a spike may be so large that nothing is left beside it.
  const double level = mesh.vertices[ring.front()].z();
  Mat3 normal = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  NeighbourPlane plane;
  for (const std::uint32_t v : ring) {
    const Vec3 d = mesh.vertices[v] - centre;
    const Vec3 row(1.0, d.x(), d.y());
    normal += row * row.transpose();
    right += (mesh.vertices[v].z() - level) * row;
    plane.distance += d.head<2>().norm();
  }
  plane.distance /= static_cast<double>(ring.size());
  // Along their narrow side the neighbours must spread by more than a hundredth of the other.
  const double xx = normal(1, 1), xy = normal(1, 2), yy = normal(2, 2);
  const double sum = xx + yy;
  if (!(xx * yy - xy * xy > 1e-4 * sum * sum)) return std::nullopt;
  const Vec3 fit = normal.ldlt().solve(right);
  if (!fit.allFinite()) return std::nullopt;
  plane.height = level + fit[0];
  plane.slope = fit.tail<2>();
  return plane;
}

}  // namespace clast::terrain_detail

#include "shapes/inscribed_ball.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "core/error.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast {
namespace {

// A surface that holds no ball of this share of its diagonal encloses nothing.
constexpr double kLeast = 1e-3;

/// A cube that may hold the centre of the largest ball.
struct Cell {
  Vec3 centre;
  double half;
  double bound;  ///< no ball with its centre in the cube is larger
  std::size_t number;

  // The largest bound first; of equals the first found.
  bool operator<(const Cell& other) const {
    return bound < other.bound || (bound == other.bound && number > other.number);
  }
};

}  // namespace

Ball largest_inscribed_ball(const TriangleMesh& mesh, double precision) {
  if (mesh.triangles.empty()) throw GeometryError("inscribed ball: the mesh has no triangles");
  const TriangleTree tree(mesh);
  const Bounds around = bounds(mesh);
  if (tree.signed_distance(around.high + Vec3::Constant(around.diagonal())) < 0.0) {
    throw GeometryError("inscribed ball: the surface faces inward");
  }
  Ball best;
  std::priority_queue<Cell> open;
  std::size_t number = 0;
  const auto wanted = [&] {
    return std::max((1.0 + precision) * best.radius, kLeast * around.diagonal());
  };
  const auto look = [&](const Vec3& centre, double half) {
    const double depth = -tree.signed_distance(centre);
    if (depth > best.radius) best = {centre, depth};
    const double bound = depth + half * std::sqrt(3.0);
    if (bound > wanted()) open.push({centre, half, bound, number++});
  };
  look(0.5 * (around.low + around.high), 0.5 * (around.high - around.low).maxCoeff());
  while (!open.empty() && open.top().bound > wanted()) {
    const Cell cell = open.top();
    open.pop();
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 side((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5,
                      (corner & 4) ? 0.5 : -0.5);
      look(cell.centre + cell.half * side, 0.5 * cell.half);
    }
  }
  if (!(best.radius > 0.0)) {
    throw GeometryError(
        "inscribed ball: no point was found inside the surface; is it closed and "
        "turned outward?");
  }
  return best;
}

}  // namespace clast

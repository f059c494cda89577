#include "mesh/weld.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/sub_mesh.hpp"

namespace clast {

namespace {

using Triangle = TriangleMesh::Triangle;

/// First vertex with exactly the same coordinates, for each vertex.
std::vector<std::uint32_t> first_of_equals(std::span<const Vec3> vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = vertices[a], &q = vertices[b];
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] != q[axis]) return p[axis] < q[axis];
    }
    return a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool equal = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = equal ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Vertices that stay, by the cube of space they are in, as chains in a table. Only ever asked for
/// the first one near a place, so that the order of the chains can't show.
class NearbyVertices {
 public:
  NearbyVertices(std::span<const Vec3> vertices, const Vec3& origin, double tolerance)
      : vertices_(vertices),
        origin_(origin),
        tolerance_(tolerance),
        heads_(std::bit_ceil(2 * vertices.size() + 1), kNoIndex),
        next_(vertices.size(), kNoIndex) {}

  /// The first vertex that stays within the tolerance, or kNoIndex.
  std::uint32_t find(const Vec3& point) const {
    const Cube low = cube(point - Vec3::Constant(tolerance_));
    const Cube high = cube(point + Vec3::Constant(tolerance_));
    std::uint32_t found = kNoIndex;
    for (std::int64_t i = low[0]; i <= high[0]; ++i) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        for (std::int64_t k = low[2]; k <= high[2]; ++k) {
          for (std::uint32_t v = heads_[slot({i, j, k})]; v != kNoIndex; v = next_[v]) {
            if (v < found && (vertices_[v] - point).norm() <= tolerance_) found = v;
          }
        }
      }
    }
    return found;
  }

  void add(std::uint32_t vertex) {
    std::uint32_t& head = heads_[slot(cube(vertices_[vertex]))];
    next_[vertex] = head;
    head = vertex;
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  static constexpr double kCube = 8.0;  ///< in tolerances: a search mostly stays in one cube

  Cube cube(const Vec3& point) const {
    Cube result{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      result[axis] =
          static_cast<std::int64_t>(std::floor((point[i] - origin_[i]) / (kCube * tolerance_)));
    }
    return result;
  }

  std::size_t slot(const Cube& cube) const {
    std::uint64_t hash = 0;
    for (const std::int64_t part : cube) {
      hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return hash & (heads_.size() - 1);
  }

  std::span<const Vec3> vertices_;
  Vec3 origin_;
  double tolerance_;
  std::vector<std::uint32_t> heads_;
  std::vector<std::uint32_t> next_;  ///< older vertex of the same slot
};

/// Key shared by the copies of a triangle.
Triangle copy_key(Triangle corners, WindingMatch match) {
  if (match == WindingMatch::kEither) {
    std::sort(corners.begin(), corners.end());
  } else {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  return corners;
}

}  // namespace

std::vector<std::uint32_t> find_weld_targets(std::span<const Vec3> vertices, double tolerance) {
  if (!(tolerance >= 0.0) || !std::isfinite(tolerance)) {
    throw InputError("weld tolerance " + format_significant(tolerance, 6) +
                     " m: must not be negative");
  }
  Bounds box;
  for (const Vec3& v : vertices) box.include(v);
  const double span = std::max(box.diagonal(), std::max(box.low.norm(), box.high.norm()));
  if (vertices.empty() || !(tolerance > std::numeric_limits<double>::epsilon() * span)) {
    return first_of_equals(vertices);
  }
  NearbyVertices staying(vertices, box.low, tolerance);
  std::vector<std::uint32_t> target(vertices.size());
  for (std::uint32_t v = 0; v < target.size(); ++v) {
    const std::uint32_t near = staying.find(vertices[v]);
    target[v] = near == kNoIndex ? v : near;
    if (near == kNoIndex) staying.add(v);
  }
  return target;
}

TriangleMesh weld_vertices(const TriangleMesh& mesh, double tolerance) {
  const std::vector<std::uint32_t> target = find_weld_targets(mesh.vertices, tolerance);
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Triangle joined = {target[t[0]], target[t[1]], target[t[2]]};
    if (!has_repeated_vertex(joined)) triangles.push_back(joined);
  }
  std::vector<bool> again(triangles.size(), false);
  for (const DuplicateTriangle& copy : find_duplicate_triangles(triangles, WindingMatch::kSame)) {
    again[copy.duplicate] = true;
  }
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!again[t]) kept.push_back(triangles[t]);
  }
  return extract_triangles(mesh, kept);
}

std::vector<DuplicateTriangle> find_duplicate_triangles(std::span<const Triangle> triangles,
                                                        WindingMatch match) {
  std::vector<std::pair<Triangle, std::uint32_t>> order;
  order.reserve(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    order.emplace_back(copy_key(triangles[t], match), t);
  }
  std::sort(order.begin(), order.end());
  std::vector<DuplicateTriangle> copies;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i].first == order[i - 1].first) {
      copies.push_back({order[i - 1].second, order[i].second});
    }
  }
  return copies;
}

}  // namespace clast

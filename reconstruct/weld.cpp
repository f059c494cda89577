#include "reconstruct/weld.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"

namespace clast {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// For every vertex the first one with exactly its coordinates.
std::vector<std::uint32_t> first_of_equals(const std::vector<Vec3>& vertices) {
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

/// A grid of kept vertices; cells are wide enough that few neighbours have to be looked at.
class NearbyVertices {
 public:
  NearbyVertices(const std::vector<Vec3>& vertices, const Vec3& origin, double tolerance)
      : vertices_(vertices),
        origin_(origin),
        tolerance_(tolerance),
        next_(vertices.size(), kNone) {}

  /// The first kept vertex within the tolerance, or none.
  std::uint32_t find(const Vec3& point) const {
    const Cell low = cell(point - Vec3::Constant(tolerance_));
    const Cell high = cell(point + Vec3::Constant(tolerance_));
    std::uint32_t found = kNone;
    for (std::int64_t i = low[0]; i <= high[0]; ++i) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        for (std::int64_t k = low[2]; k <= high[2]; ++k) {
          const auto entry = newest_.find(Cell{i, j, k});
          if (entry == newest_.end()) continue;
          for (std::uint32_t v = entry->second; v != kNone; v = next_[v]) {
            if ((vertices_[v] - point).norm() <= tolerance_) found = std::min(found, v);
          }
        }
      }
    }
    return found;
  }

  void keep(std::uint32_t vertex) {
    const auto [entry, fresh] = newest_.try_emplace(cell(vertices_[vertex]), vertex);
    if (!fresh) {
      next_[vertex] = entry->second;
      entry->second = vertex;
    }
  }

 private:
  Cell cell(const Vec3& point) const {
    Cell result;
    for (int axis = 0; axis < 3; ++axis) {
      result[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(
          std::floor((point[axis] - origin_[axis]) / (kCellWidth * tolerance_)));
    }
    return result;
  }

  static constexpr double kCellWidth = 4.0;  ///< in tolerances
  const std::vector<Vec3>& vertices_;
  Vec3 origin_;
  double tolerance_;
  std::unordered_map<Cell, std::uint32_t, CellHash> newest_;
  std::vector<std::uint32_t> next_;  ///< older vertex of the same cell
};

/// Marks triangles that repeat an earlier one, same corners in the same turn.
std::vector<bool> repeated(const std::vector<TriangleMesh::Triangle>& triangles) {
  std::vector<std::pair<TriangleMesh::Triangle, std::uint32_t>> order;
  order.reserve(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    TriangleMesh::Triangle turned = triangles[t];
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    order.emplace_back(turned, t);
  }
  std::sort(order.begin(), order.end());
  std::vector<bool> result(triangles.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i].first == order[i - 1].first) result[order[i].second] = true;
  }
  return result;
}

}  // namespace

TriangleMesh welded(const TriangleMesh& mesh, double tolerance) {
  if (!(tolerance >= 0.0) || !std::isfinite(tolerance)) {
    throw InputError("weld tolerance " + with_digits(tolerance, 6) + " m: must not be negative");
  }
  const Bounds box = bounds(mesh);
  std::vector<std::uint32_t> target = first_of_equals(mesh.vertices);
  // Below the rounding of the coordinates only equal vertices can be meant.
  const double span = std::max(box.diagonal(), std::max(box.low.norm(), box.high.norm()));
  if (!mesh.vertices.empty() && tolerance > std::numeric_limits<double>::epsilon() * span) {
    NearbyVertices kept(mesh.vertices, box.low, tolerance);
    for (std::uint32_t v = 0; v < target.size(); ++v) {
      if (target[v] != v) {
        target[v] = target[target[v]];
        continue;
      }
      const std::uint32_t near = kept.find(mesh.vertices[v]);
      if (near == kNone) {
        kept.keep(v);
      } else {
        target[v] = near;
      }
    }
  }

  std::vector<TriangleMesh::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const TriangleMesh::Triangle joined = {target[t[0]], target[t[1]], target[t[2]]};
    if (!collapsed(joined)) triangles.push_back(joined);
  }
  const std::vector<bool> again = repeated(triangles);
  std::vector<bool> used(mesh.vertices.size(), false);
  TriangleMesh result;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (again[t]) continue;
    result.triangles.push_back(triangles[t]);
    for (const std::uint32_t corner : triangles[t]) used[corner] = true;
  }
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!used[v]) continue;
    number[v] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(mesh.vertices[v]);
  }
  for (TriangleMesh::Triangle& t : result.triangles) {
    t = {number[t[0]], number[t[1]], number[t[2]]};
  }
  return result;
}

}  // namespace clast

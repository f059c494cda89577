#include "reconstruct/repair/spikes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/statistics/statistics.hpp"
#include "core/types.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/vertex_corners.hpp"

namespace clast::reconstruct_detail {

namespace {

using Triangle = TriangleMesh::Triangle;

/// Minimum evidence that a vertex is a spike, which depends on its height.
struct Evidence {
  double edges;     ///< height over a typical edge of the mesh, at least
  double radii;     ///< height over the mean distance of the neighbours from their centroid
  double angle;     ///< by which the surface around it bends towards it, rad
  double flatness;  ///< by which it bends towards the foot instead, as a share of that, at most
};

constexpr double kLowest = 0.75;  ///< least height of a spike, in typical edges
/// Any of these shows a spike, the taller the more easily. Around the tip of a ridge or of a coarse
/// polyhedron the surface goes on to the tip and bends more towards the foot. On rough rocks there
/// are vertices that meet the last but for the height.
constexpr Evidence kShown[] = {
    {2.5, 1.5, 0.0, 1.2}, {1.2, 1.5, 0.0, 0.8}, {kLowest, 0.9, 0.25 * kPi, 0.5}};
/// Passes: a vertex beside a spike looks sound only when that is gone.
constexpr int kPasses = 3;

/// Doubled area, towards the side from which the corners turn counter-clockwise.
Vec3 doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The median of the lengths, each as often as the square of it: holes are filled with triangles
/// that are many and small.
double typical(std::vector<double> lengths) {
  std::sort(lengths.begin(), lengths.end());
  double whole = 0.0, half = 0.0;
  for (const double length : lengths) whole += length * length;
  for (const double length : lengths) {
    half += length * length;
    if (2.0 * half >= whole) return length;
  }
  return 0.0;
}

/// Position of a vertex without its spike, and the height of the spike.
struct SpikeFoot {
  Vec3 position = Vec3::Zero();
  double height = 0.0;
  double radii = 0.0;  ///< height over the mean distance of the neighbours from their centroid
};

/// A mesh and what lies around each of its vertices.
class Surroundings {
 public:
  explicit Surroundings(const TriangleMesh& mesh)
      : mesh_(mesh),
        across_(3 * mesh.triangles.size(), kNoIndex),
        at_border_(mesh.vertices.size(), false),
        corners_(mesh) {
    std::vector<double> lengths;
    const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
    for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
      lengths.push_back((mesh.vertices[sides[0].high] - mesh.vertices[sides[0].low]).norm());
      if (sides.size() != 2) {
        at_border_[sides[0].low] = at_border_[sides[0].high] = true;
        return;
      }
      for (const std::size_t i : {0u, 1u}) {
        across_[sides[i].opposite_corner()] = vertex(sides[1 - i].opposite_corner());
      }
    });
    edge_ = typical(std::move(lengths));
  }

  bool at_border(std::uint32_t v) const { return at_border_[v]; }

  /// The centroid of the neighbours.
  /// @param v  not at a border
  Vec3 centroid(std::uint32_t v) const {
    Vec3 sum = Vec3::Zero();
    for_each_corner(v, [&](std::uint32_t c) { sum += position(next(c)); });
    return sum / static_cast<double>(degree(v));
  }

  /// None for a vertex that doesn't stand out.
  std::optional<SpikeFoot> foot_of(std::uint32_t v) const {
    const std::optional<SpikeFoot> foot = at_border_[v] ? foot_at_border(v) : foot_inside(v);
    if (!foot || foot->height <= kLowest * edge_) return std::nullopt;
    const std::optional<double> own = bending(v, mesh_.vertices[v]);
    if (!own) return std::nullopt;
    const double flat = *bending(v, foot->position);
    const bool shown =
        std::any_of(std::begin(kShown), std::end(kShown), [&](const Evidence& least) {
          return foot->height > least.edges * edge_ && foot->radii > least.radii &&
                 *own > least.angle && flat < least.flatness * *own;
        });
    return shown ? foot : std::nullopt;
  }

 private:
  std::size_t degree(std::uint32_t v) const { return corners_.corners_of(v).size(); }

  static std::uint32_t next(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }

  std::uint32_t vertex(std::uint32_t c) const { return mesh_.triangles[c / 3][c % 3]; }

  const Vec3& position(std::uint32_t c) const { return mesh_.vertices[vertex(c)]; }

  template <class Use>
  void for_each_corner(std::uint32_t v, const Use& use) const {
    for (const std::uint32_t c : corners_.corners_of(v)) use(c);
  }

  /// Normal, as long as the doubled area, of the triangle across from a corner.
  Vec3 beyond(std::uint32_t c) const {
    return doubled_area(position(next(next(c))), position(next(c)), mesh_.vertices[across_[c]]);
  }

  /// The centroid of the neighbours.
  std::optional<SpikeFoot> foot_inside(std::uint32_t v) const {
    if (degree(v) < 3) return std::nullopt;
    const Vec3 middle = centroid(v);
    double radius = 0.0;
    for_each_corner(v, [&](std::uint32_t c) { radius += (position(next(c)) - middle).norm(); });
    radius /= static_cast<double>(degree(v));
    const double height = (mesh_.vertices[v] - middle).norm();
    return SpikeFoot{middle, height, height / radius};
  }

  /// The projection to the plane of the surface beyond the triangles at the vertex.
  std::optional<SpikeFoot> foot_at_border(std::uint32_t v) const {
    Vec3 normal = Vec3::Zero(), middle = Vec3::Zero();
    std::vector<Vec3> near;
    for_each_corner(v, [&](std::uint32_t c) {
      if (across_[c] == kNoIndex) return;
      normal += beyond(c);
      for (const std::uint32_t end : {next(c), next(next(c))}) {
        near.push_back(position(end));
        middle += near.back();
      }
    });
    if (!(normal.norm() > 0.0)) return std::nullopt;
    normal.normalize();
    middle /= static_cast<double>(near.size());
    double radius = 0.0;
    for (const Vec3& p : near) radius += (p - middle).norm() / static_cast<double>(near.size());
    const double height = (mesh_.vertices[v] - middle).dot(normal);
    return SpikeFoot{mesh_.vertices[v] - height * normal, std::abs(height),
                     std::abs(height) / radius};
  }

  /// The median angle by which the surface beyond the triangles at `v` bends towards them, if that
  /// vertex lies at `at`; none where there is nothing beyond.
  std::optional<double> bending(std::uint32_t v, const Vec3& at) const {
    std::vector<double> angles;
    for_each_corner(v, [&](std::uint32_t c) {
      if (across_[c] == kNoIndex) return;
      angles.push_back(
          angle_between(doubled_area(at, position(next(c)), position(next(next(c)))), beyond(c)));
    });
    if (angles.empty()) return std::nullopt;
    return upper_median(std::move(angles));
  }

  const TriangleMesh& mesh_;
  /// For each corner 3 t + k (vertex k of triangle t), the vertex of the triangle across the
  /// opposite side that is not on that side.
  std::vector<std::uint32_t> across_;
  std::vector<bool> at_border_;
  VertexCorners corners_;
  double edge_ = 0.0;  ///< half of the surface has longer ones
};

}  // namespace

SpikeSummary flatten_spikes(TriangleMesh& mesh) {
  SpikeSummary result;
  const Surroundings around(mesh);
  std::vector<bool> moved(mesh.vertices.size(), false);
  for (int pass = 0; pass < kPasses; ++pass) {
    std::vector<std::pair<double, std::uint32_t>> found;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      if (const auto foot = around.foot_of(v)) found.emplace_back(-foot->height, v);
    }
    if (found.empty()) break;
    std::sort(found.begin(), found.end());  // the tallest first
    for (const auto& [depth, v] : found) {
      const std::optional<SpikeFoot> foot = around.foot_of(v);
      if (!foot) continue;
      if (foot->height > result.max_height) {
        result.max_height = foot->height;
        result.position = mesh.vertices[v];
      }
      mesh.vertices[v] = foot->position;
      moved[v] = true;
    }
  }
  // Moved vertices may lie between neighbours that were spikes themselves.
  for (std::uint32_t v = 0; v < moved.size(); ++v) {
    if (!moved[v]) continue;
    ++result.count;
    if (!around.at_border(v)) mesh.vertices[v] = around.centroid(v);
  }
  return result;
}

}  // namespace clast::reconstruct_detail

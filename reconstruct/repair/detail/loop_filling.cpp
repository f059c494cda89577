#include "reconstruct/repair/detail/loop_filling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
/// Height over longest side below which a triangle has no normal.
constexpr double kFlatTriangle = 1e-6;
/// A triangle of the lowest or highest filling is no longer than this, times the longest side of
/// the loop, and faces as the loop does.
constexpr double kMaxFilling = 3.0;

/// The triangulations of one polygon, by dynamic programming over its chords.
class Triangulations {
 public:
  Triangulations(const TriangleMesh& mesh, std::span<const std::uint32_t> loop,
                 std::span<const Vec3> normals, const std::set<EdgeKey>& edges)
      : mesh_(mesh), loop_(loop), normals_(normals), n_(loop.size()), free_(n_ * n_, false) {
    for (std::size_t i = 0; i < n_; ++i) {
      centre_ += point(i) / static_cast<double>(n_);
      longest_side_ = std::max(longest_side_, (point((i + 1) % n_) - point(i)).norm());
      for (std::size_t k = i + 1; k < n_; ++k) {
        free_[i * n_ + k] = is_side(i, k) || (loop[i] != loop[k] &&
                                              !edges.contains(make_edge_key(loop[i], loop[k])));
      }
    }
    for (std::size_t i = 0; i < n_; ++i) {
      area_ += 0.5 * (point(i) - centre_).cross(point((i + 1) % n_) - centre_);
    }
  }

  /// The one that bends least; empty where there is none.
  std::vector<TriangleMesh::Triangle> smoothest() {
    normal_.assign(n_ * n_, Vec3::Zero());
    for (std::size_t i = 0; i + 1 < n_; ++i) normal_[i * n_ + i + 1] = normals_[i];
    return best([&](std::size_t i, std::size_t m, std::size_t k) { return bends(i, m, k); },
                [&](std::size_t i, std::size_t m, std::size_t k) {
                  normal_[i * n_ + k] = area_of(i, m, k).normalized();
                });
  }

  /// The one that encloses least (sign 1) or most (-1), of those without folds; as above.
  std::vector<TriangleMesh::Triangle> extreme(double sign) {
    return best(
        [&](std::size_t i, std::size_t m, std::size_t k) {
          const Vec3 area = area_of(i, m, k);
          if (!(area.dot(area_) > 0.0) || longest(i, m, k) > kMaxFilling * longest_side_) {
            return kNever;
          }
          return sign * sixfold(i, m, k);
        },
        [](std::size_t, std::size_t, std::size_t) {});
  }

  /// Six times the volume under the triangles, over the middle of the loop.
  double sixfold_volume(const std::vector<TriangleMesh::Triangle>& triangles) const {
    double sum = 0.0;
    for (const auto& [a, b, c] : triangles) {
      sum += (mesh_.vertices[a] - centre_)
                 .dot((mesh_.vertices[b] - centre_).cross(mesh_.vertices[c] - centre_));
    }
    return sum;
  }

  double area(const std::vector<TriangleMesh::Triangle>& triangles) const {
    double sum = 0.0;
    for (const TriangleMesh::Triangle& t : triangles) sum += triangle_area(mesh_, t);
    return sum;
  }

 private:
  const Vec3& point(std::size_t i) const { return mesh_.vertices[loop_[i]]; }
  bool is_side(std::size_t i, std::size_t k) const { return k == i + 1 || (i == 0 && k + 1 == n_); }
  Vec3 area_of(std::size_t i, std::size_t m, std::size_t k) const {
    return (point(m) - point(i)).cross(point(k) - point(i));
  }
  double sixfold(std::size_t i, std::size_t m, std::size_t k) const {
    return (point(i) - centre_).dot((point(m) - centre_).cross(point(k) - centre_));
  }
  double longest(std::size_t i, std::size_t m, std::size_t k) const {
    return std::max(
        {(point(m) - point(i)).norm(), (point(k) - point(m)).norm(), (point(i) - point(k)).norm()});
  }

  double bends(std::size_t i, std::size_t m, std::size_t k) const {
    const Vec3 area = area_of(i, m, k);
    const double side = longest(i, m, k);
    if (!(area.norm() > kFlatTriangle * side * side)) return kNever;
    const Vec3 normal = area.normalized();
    const auto bending = [&](std::size_t from, std::size_t to, const Vec3& beyond) {
      return (point(to) - point(from)).norm() *
             std::atan2(normal.cross(beyond).norm(), normal.dot(beyond));
    };
    double sum = bending(i, m, normal_[i * n_ + m]) + bending(m, k, normal_[m * n_ + k]);
    if (i == 0 && k + 1 == n_) sum += bending(k, i, normals_[n_ - 1]);
    return sum;
  }

  template <class Cost, class Settle>
  std::vector<TriangleMesh::Triangle> best(const Cost& cost, const Settle& settle) {
    std::vector<double> least(n_ * n_, kNever);
    std::vector<std::size_t> apex(n_ * n_, 0);
    for (std::size_t i = 0; i + 1 < n_; ++i) least[i * n_ + i + 1] = 0.0;
    for (std::size_t span = 2; span < n_; ++span) {
      for (std::size_t i = 0; i + span < n_; ++i) {
        const std::size_t k = i + span;
        if (!free_[i * n_ + k]) continue;
        for (std::size_t m = i + 1; m < k; ++m) {
          const double parts = least[i * n_ + m] + least[m * n_ + k];
          if (parts == kNever || loop_[m] == loop_[i] || loop_[m] == loop_[k]) continue;
          const double whole = parts + cost(i, m, k);
          if (whole >= least[i * n_ + k]) continue;
          least[i * n_ + k] = whole;
          apex[i * n_ + k] = m;
        }
        if (least[i * n_ + k] < kNever) settle(i, apex[i * n_ + k], k);
      }
    }
    std::vector<TriangleMesh::Triangle> triangles;
    if (least[n_ - 1] == kNever) return triangles;
    std::vector<std::array<std::size_t, 2>> chords = {{0, n_ - 1}};
    while (!chords.empty()) {
      const auto [i, k] = chords.back();
      chords.pop_back();
      if (k - i < 2) continue;
      const std::size_t m = apex[i * n_ + k];
      triangles.push_back({loop_[i], loop_[m], loop_[k]});
      chords.push_back({i, m});
      chords.push_back({m, k});
    }
    return triangles;
  }

  const TriangleMesh& mesh_;
  std::span<const std::uint32_t> loop_;
  std::span<const Vec3> normals_;
  std::size_t n_;
  std::vector<bool> free_;    ///< may there be an edge between the corners?
  std::vector<Vec3> normal_;  ///< of the triangle on the chord from i to k, inside
  Vec3 centre_ = Vec3::Zero(), area_ = Vec3::Zero();
  double longest_side_ = 0.0;
};

/// True if two chords of the filling join the same vertices. If a loop passes a vertex twice, the
/// search by corners does not notice this.
bool repeats_an_edge(const std::vector<TriangleMesh::Triangle>& triangles) {
  std::vector<EdgeKey> keys;
  for (const TriangleMesh::Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) keys.push_back(make_edge_key(t[k], t[(k + 1) % 3]));
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 2; i < keys.size(); ++i) {
    if (keys[i] == keys[i - 2]) return true;
  }
  return false;
}

}  // namespace

std::optional<LoopFilling> triangulate_loop(const TriangleMesh& mesh,
                                            std::span<const std::uint32_t> loop,
                                            std::span<const Vec3> normals,
                                            const std::set<EdgeKey>& edges) {
  if (loop.size() < 3) return std::nullopt;
  Triangulations all(mesh, loop, normals, edges);
  LoopFilling filling;
  filling.triangles = all.smoothest();
  if (filling.triangles.empty() || repeats_an_edge(filling.triangles)) return std::nullopt;
  filling.area = all.area(filling.triangles);
  const double chosen = all.sixfold_volume(filling.triangles);
  if (loop.size() > 3) {
    const std::vector<TriangleMesh::Triangle> low = all.extreme(1.0), high = all.extreme(-1.0);
    if (!low.empty()) filling.volume_below = std::max(0.0, chosen - all.sixfold_volume(low)) / 6.0;
    if (!high.empty()) {
      filling.volume_above = std::max(0.0, all.sixfold_volume(high) - chosen) / 6.0;
    }
  }
  if (loop.size() > 4) {
    std::vector<Vec3> border;
    for (const std::uint32_t v : loop) border.push_back(mesh.vertices[v]);
    const TangentConeVolumes cones = tangent_cone_volumes(border, normals);
    filling.volume_below = std::max(filling.volume_below, cones.below + chosen / 6.0);
    filling.volume_above = std::max(filling.volume_above, cones.above - chosen / 6.0);
  }
  return filling;
}

TangentConeVolumes tangent_cone_volumes(std::span<const Vec3> border,
                                        std::span<const Vec3> normals) {
  const std::size_t n = border.size();
  Vec3 centre = Vec3::Zero(), area = Vec3::Zero();
  for (const Vec3& p : border) centre += p / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    area += 0.5 * (border[i] - centre).cross(border[(i + 1) % n] - centre);
  }
  const double size = area.norm();
  TangentConeVolumes cones;
  if (!(size > 0.0)) return cones;
  const Vec3 up = area / size;
  const double reach = std::sqrt(size / kPi);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 middle = 0.5 * (border[i] + border[(i + 1) % n]);
    const double steepness = normals[i].dot(up);
    const double height =
        steepness > 0.0 ? std::clamp(normals[i].dot(middle - centre) / steepness, -reach, reach)
                        : reach;
    const double volume = size * std::abs(height) / (3.0 * static_cast<double>(n));
    (height > 0.0 ? cones.above : cones.below) += volume;
  }
  return cones;
}

}  // namespace clast::reconstruct_detail

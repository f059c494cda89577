#include "shapes/core_fit.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/edge_collapse.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/surface_samples.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_tree.hpp"
#include "shapes/detail/rounded_surface_distance.hpp"

namespace clast {

namespace {

using Mat9 = Eigen::Matrix<double, 9, 9>;
using Vec9 = Eigen::Matrix<double, 9, 1>;

/// Points on either surface: so many for each core vertex, within limits.
constexpr std::size_t kPointsPerVertex = 60, kMinFitPoints = 3000, kMaxFitPoints = 12000;
constexpr int kSkinSegments = 4;  ///< pieces per quarter turn of the skin that is sampled
/// Tips stick out farthest, and spread points miss them: this many scan vertices are looked at too.
constexpr std::size_t kScanVertices = 25000;
/// A fit that didn't get this much nearer in so many rounds has ended.
constexpr double kProgress = 0.99;
constexpr int kRoundsWithoutProgress = 12;
constexpr double kMaxPower = 8.0, kPowerPerRound = 0.5;
/// Damping over the mean diagonal: unobserved vertices stay in place, neighbours move together.
constexpr double kDamping = 1e-3, kSmoothing = 0.3;
/// A core this many times worse than the best is given up, and the step from the best cut.
constexpr double kWorse = 1.1;
constexpr double kLongestStep = 2.0;  ///< in largest distances
constexpr double kOnFittedSkin =
    1e-6;  ///< share of the radius by which a skin point may lie inside
/// Least cosine between a core triangle's normals before and after a step.
constexpr double kTurn = 0.3;
/// Tries with shorter steps of the vertices in the way, before their edges are collapsed, and
/// before they and their neighbours stay where they are.
constexpr int kShorterTries = 3, kTries = 12;
constexpr double kShorter = 0.3, kLonger = 1.5;
constexpr int kRoundsAfterCollapse = 6;  ///< left to repair what a collapse did
/// Share of the largest distance so far from which a point inside the body is looked at closely.
constexpr double kDeep = 0.5;
/// A fit that, after this many rounds, is still this many times too far won't get there.
constexpr int kRoundsOfHope = 8;
constexpr double kHope = 1.5;

/// A point and what it wants: the core at `weights` of `triangle` moved by `gap` along `direction`.
struct Pull {
  std::uint32_t triangle;
  Vec3 weights, direction;
  double gap;
};

struct Pulls {
  std::vector<Pull> list;
  double largest = 0.0;

  void add(const TriangleTree::SignedClosest& on_core, const Vec3& direction, double gap) {
    list.push_back({on_core.triangle, on_core.weights, direction, gap});
    largest = std::max(largest, std::abs(gap));
  }
};

class Fit {
 public:
  Fit(const ScanSurface& scan, const SpheroPolyhedron& start, const CoreFitOptions& options)
      : scan_(scan),
        radius_(start.radius),
        size_(bounds(scan.mesh()).diagonal()),
        options_(options),
        count_(std::clamp(kPointsPerVertex * start.vertices.size(), kMinFitPoints, kMaxFitPoints)),
        points_(sample_surface(scan.mesh(), count_)),
        core_(core_mesh(start)) {
    const std::vector<Vec3>& vertices = scan.mesh().vertices;
    const std::size_t stride = (vertices.size() + kScanVertices - 1) / kScanVertices;
    for (std::size_t v = 0; v < vertices.size(); v += stride) points_.push_back(vertices[v]);
  }

  TriangleMesh best() {
    TriangleMesh best = core_;
    Pulls best_pulls;
    double least = 1e300, milestone = 1e300, share = 1.0;
    int since_milestone = 0;
    for (int round = 0; round <= options_.rounds; ++round) {
      Pulls pulls = measured();
      if (pulls.largest < least) {
        least = pulls.largest;
        best = core_;
        best_pulls = pulls;
      }
      ++since_milestone;
      if (least <= kProgress * milestone) {
        milestone = least;
        since_milestone = 0;
      }
      if (since_milestone == kRoundsWithoutProgress) break;
      if (least <= options_.target_distance || round == options_.rounds) break;
      if (round >= kRoundsOfHope && least > kHope * options_.abandon_distance) break;
      if (pulls.largest > kWorse * least) {
        share *= kShorter;
        may_collapse_ = false;
        core_ = best;
        pulls = best_pulls;
      } else {
        share = std::min(1.0, kLonger * share);
      }
      const double power = std::min(kMaxPower, 2.0 + kPowerPerRound * round);
      if (!move(steps(pulls, power, share), round)) break;
    }
    return best;
  }

 private:
  Pulls measured() {
    const TriangleTree tree(core_);
    Pulls pulls;
    const shapes_detail::RoundedSurfaceDistance skin_distance(tree, radius_, 2.0 * size_);
    std::uint32_t hint = 0;  // neighbours in the list are mostly neighbours in space
    for (const Vec3& point : points_) {
      const TriangleTree::SignedClosest near = tree.signed_closest_point(point, hint);
      hint = near.triangle;
      double gap = near.distance - radius_;
      // Under a crease of the skin the next bare place is farther than the skin that is buried.
      if (gap < -kDeep * pulls.largest) gap = skin_distance(point);
      pulls.add(near, near.outward, gap);
    }

    const TriangleMesh skin =
        rounded_surface_mesh(make_sphero_polyhedron(core_, radius_), kSkinSegments);
    std::vector<Vec3> on_skin = sample_surface(skin, count_);
    on_skin.insert(on_skin.end(), skin.vertices.begin(), skin.vertices.end());
    std::uint32_t scan_hint = 0;
    for (const Vec3& near_skin : on_skin) {
      const TriangleTree::SignedClosest foot = tree.signed_closest_point(near_skin, hint);
      hint = foot.triangle;
      const Vec3 point = foot.foot + radius_ * foot.outward;
      if (tree.signed_distance(point, hint) < (1.0 - kOnFittedSkin) * radius_) continue;
      const TriangleTree::SignedClosest on_scan =
          scan_.tree().signed_closest_point(point, scan_hint);
      scan_hint = on_scan.triangle;
      pulls.add(foot, on_scan.outward, -on_scan.distance);
    }
    return pulls;
  }

  /// Newton's step for the sum of |gap|^power: that of weighted least squares over power - 1.
  std::vector<Vec3> steps(const Pulls& pulls, double power, double share) const {
    std::vector<Mat9> blocks(core_.triangles.size(), Mat9::Zero());
    std::vector<Vec9> sides(core_.triangles.size(), Vec9::Zero());
    for (const Pull& pull : pulls.list) {
      const double weight = std::pow(std::abs(pull.gap) / pulls.largest, power - 2.0);
      Vec9 row;
      row << pull.weights[0] * pull.direction, pull.weights[1] * pull.direction,
          pull.weights[2] * pull.direction;
      blocks[pull.triangle] += weight * row * row.transpose();
      sides[pull.triangle] += weight * pull.gap * row;
    }
    const std::size_t count = core_.vertices.size();
    const auto size = static_cast<Eigen::Index>(3 * count);
    double trace = 0.0;
    for (const Mat9& block : blocks) trace += block.trace();
    const double mean = trace / static_cast<double>(size);

    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(81 * blocks.size() + 6 * 12 * count);
    Eigen::VectorXd side = Eigen::VectorXd::Zero(size);
    for (std::size_t t = 0; t < blocks.size(); ++t) {
      const auto place = [&](int i) {
        const auto corner = core_.triangles[t][static_cast<std::size_t>(i / 3)];
        return static_cast<int>(3 * corner) + i % 3;
      };
      for (int i = 0; i < 9; ++i) {
        side[place(i)] += sides[t][i];
        for (int j = 0; j < 9; ++j) entries.emplace_back(place(i), place(j), blocks[t](i, j));
      }
      for (int k = 0; k < 3; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
          const int from = place(3 * k + axis), to = place(3 * ((k + 1) % 3) + axis);
          // Every edge is seen from both of its triangles.
          for (const int end : {from, to}) entries.emplace_back(end, end, kSmoothing * mean / 2);
          entries.emplace_back(from, to, -kSmoothing * mean / 2);
          entries.emplace_back(to, from, -kSmoothing * mean / 2);
        }
      }
    }
    for (int i = 0; i < static_cast<int>(size); ++i) entries.emplace_back(i, i, kDamping * mean);
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::VectorXd solution = share / (power - 1.0) * solver.solve(side);

    std::vector<Vec3> result(count, Vec3::Zero());
    if (!solution.allFinite()) return result;
    const double longest = kLongestStep * pulls.largest;
    for (std::size_t v = 0; v < count; ++v) {
      result[v] = solution.segment<3>(static_cast<Eigen::Index>(3 * v));
      const double length = result[v].norm();
      if (length > longest) result[v] *= longest / length;
    }
    return result;
  }

  /// Triangles that would turn over or cross others.
  std::vector<std::uint32_t> in_the_way(const TriangleMesh& moved) const {
    std::vector<std::uint32_t> bad;
    for (std::uint32_t t = 0; t < core_.triangles.size(); ++t) {
      const Vec3 before = unit_normal(core_, core_.triangles[t]);
      const Vec3 after = unit_normal(moved, moved.triangles[t]);
      if (!(before.dot(after) > kTurn)) bad.push_back(t);
    }
    if (!bad.empty()) return bad;
    for (const auto& pair : find_self_intersections(moved))
      bad.insert(bad.end(), pair.begin(), pair.end());
    std::sort(bad.begin(), bad.end());
    bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
    return bad;
  }

  bool collapse(const std::vector<std::uint32_t>& bad) {
    TriangleMesh collapsed = core_;
    if (collapse_triangle_edges(collapsed, bad) == 0) return false;
    if (!find_self_intersections(collapsed).empty()) return false;
    core_ = std::move(collapsed);
    return true;
  }

  /// Takes the step, or as much of it as is possible. False: nothing is.
  bool move(std::vector<Vec3> step, int round) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      TriangleMesh moved = core_;
      for (std::size_t v = 0; v < step.size(); ++v) moved.vertices[v] += step[v];
      const std::vector<std::uint32_t> bad = in_the_way(moved);
      if (bad.empty()) {
        core_ = std::move(moved);
        return true;
      }
      if (attempt == kShorterTries && may_collapse_ &&
          round + kRoundsAfterCollapse < options_.rounds && collapse(bad)) {
        return true;
      }
      std::vector<bool> held(step.size(), false);
      for (const std::uint32_t t : bad) {
        for (const std::uint32_t v : core_.triangles[t]) held[v] = true;
      }
      if (attempt <= kShorterTries) {
        for (std::size_t v = 0; v < step.size(); ++v) {
          if (held[v]) step[v] *= kShorter;
        }
        continue;
      }
      for (const auto& [a, b, c] : core_.triangles) {
        if (held[a] || held[b] || held[c]) step[a] = step[b] = step[c] = Vec3::Zero();
      }
    }
    return false;
  }

  const ScanSurface& scan_;
  double radius_, size_;
  CoreFitOptions options_;
  std::size_t count_;
  std::vector<Vec3> points_;  ///< on the scan
  TriangleMesh core_;
  bool may_collapse_ = true;  ///< until a core had to be given up
};

}  // namespace

void CoreFitOptions::check() const {
  if (rounds < 0) {
    throw InputError("rounds = " + std::to_string(rounds) + ": must be zero or more");
  }
  if (!(target_distance >= 0.0) || !(abandon_distance >= 0.0)) {
    throw InputError("good_enough = " + format_significant(target_distance, 6) +
                     " and hopeless = " + format_significant(abandon_distance, 6) +
                     ": must be zero or more");
  }
}

SpheroPolyhedron fit_core(const ScanSurface& scan, const SpheroPolyhedron& start,
                          const CoreFitOptions& options) {
  options.check();
  if (start.faces.empty()) throw GeometryError("a core without faces can't be fitted to a scan");
  return make_sphero_polyhedron(Fit(scan, start, options).best(), start.radius);
}

}  // namespace clast

#include "shapes/core_fit.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "mesh/edge_collapse.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/surface_samples.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_tree.hpp"
#include "shapes/detail/deviation_search.hpp"
#include "shapes/detail/rounded_surface_distance.hpp"

namespace clast {

namespace {

using Mat9 = Eigen::Matrix<double, 9, 9>;
using Vec9 = Eigen::Matrix<double, 9, 1>;

/// Number of points on either surface for each core vertex, and its limits.
constexpr std::size_t kPointsPerVertex = 12, kMinFitPoints = 2000, kMaxFitPoints = 12000;
/// Points on a scan that is coarser than these: one per triangle, but at least this many.
constexpr std::size_t kMinTrianglePoints = 500;
/// Searches for points that the samples missed, and rounds that follow each at least.
constexpr int kMaxSearches = 20, kRoundsAfterSearch = 8;
constexpr std::size_t kPointChunk = 64;  ///< points that one thread takes at a time
/// A fit that didn't get this much nearer in so many rounds has ended.
constexpr double kProgress = 0.99;
constexpr int kRoundsWithoutProgress = 5;
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
/// Depth inside the body, as a fraction of `target_distance`, from which a point may lie under a
/// crease.
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
};

/// Point of the rounded surface over a point of the core.
struct BodyPoint {
  std::uint32_t triangle;
  Vec3 weights;     ///< barycentric coordinates of the core point
  int feature = 0;  ///< face, vertex or side that it lies on, as in `TriangleTree::Closest`
  std::optional<Vec3> direction = {};  ///< from the core point, instead of the normal of `feature`
};

/// A core and the points of its rounded surface at which the distance to the scan is measured.
struct Core {
  TriangleMesh mesh;
  std::vector<BodyPoint> points;
};

std::size_t count_fit_points(std::size_t core_vertices, std::size_t scan_triangles) {
  return std::min(std::clamp(kPointsPerVertex * core_vertices, kMinFitPoints, kMaxFitPoints),
                  std::max(kMinTrianglePoints, scan_triangles));
}

class Fit {
 public:
  Fit(const ScanSurface& scan, const SpheroPolyhedron& start, const CoreFitOptions& options)
      : scan_(scan),
        radius_(start.radius),
        size_(bounds(scan.mesh()).diagonal()),
        options_(options),
        count_(count_fit_points(start.vertices.size(), scan.mesh().triangles.size())),
        scan_points_(sample_surface(scan.mesh(), count_)),
        core_{core_mesh(start), {}},
        threads_(options.threads) {
    core_.points = sample_body();
  }

  CoreFit best() {
    Core best = core_;
    Pulls best_pulls;
    double least = 1e300, milestone = 1e300, share = 1.0;
    int since_milestone = 0, searches = 0, last_round = options_.rounds;
    for (int round = 0; round <= last_round; ++round) {
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
      const bool ended = since_milestone == kRoundsWithoutProgress || round == last_round;
      if (least <= options_.target_distance || (ended && least <= options_.max_distance)) {
        core_ = best;
        const SpheroPolyhedron body = corrected();
        core_.mesh = core_mesh(body);
        if (!add_distant_points()) return {body, options_.max_distance};
        if (searches++ == kMaxSearches) return {body};
        least = milestone = 1e300;
        since_milestone = 0;
        share = 1.0;
        last_round = std::max(last_round, round + kRoundsAfterSearch);
        continue;
      }
      if (ended) break;
      if (round >= kRoundsOfHope && least > kHope * options_.max_distance) break;
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
    core_ = best;
    return {corrected()};
  }

 private:
  SpheroPolyhedron corrected() const {
    SpheroPolyhedron body = make_sphero_polyhedron(core_.mesh, radius_);
    return options_.correct ? options_.correct(std::move(body)) : body;
  }

  template <typename Body>
  void for_each_in_chunks(std::size_t count, const Body& body) {
    threads_.run((count + kPointChunk - 1) / kPointChunk, 1, [&](std::size_t chunk) {
      for (std::size_t i = chunk * kPointChunk; i < std::min(count, (chunk + 1) * kPointChunk); ++i)
        body(i);
    });
  }

  Pulls measured() {
    const TriangleTree tree(core_.mesh);
    std::vector<std::optional<Pull>> pulls(scan_points_.size());
    scan_point_hints_.resize(scan_points_.size(), 0);
    const auto core_triangle = [&](std::uint32_t hint) {
      return hint < core_.mesh.triangles.size() ? hint : 0;
    };
    for_each_in_chunks(scan_points_.size(), [&](std::size_t i) {
      std::uint32_t& hint = scan_point_hints_[i];
      const TriangleTree::SignedClosest near =
          tree.signed_closest_point(scan_points_[i], core_triangle(hint));
      hint = near.triangle;
      pulls[i] = {near.triangle, near.weights, near.outward, near.distance - radius_};
    });

    pulls.resize(scan_points_.size() + core_.points.size());
    body_point_hints_.resize(core_.points.size(), {0, 0});
    for_each_in_chunks(core_.points.size(), [&](std::size_t i) {
      auto& [core_hint, scan_hint] = body_point_hints_[i];
      const Vec3 near_surface = position(core_.points[i], tree);
      const TriangleTree::SignedClosest foot =
          tree.signed_closest_point(near_surface, core_triangle(core_hint));
      core_hint = foot.triangle;
      const Vec3 point = foot.foot + radius_ * foot.outward;
      if (tree.signed_distance(point, core_hint) < (1.0 - kOnFittedSkin) * radius_) return;
      const TriangleTree::SignedClosest on_scan =
          scan_.tree().signed_closest_point(point, scan_hint);
      scan_hint = on_scan.triangle;
      pulls[scan_points_.size() + i] = {foot.triangle, foot.weights, on_scan.outward,
                                        -on_scan.distance};
    });

    // Under a crease the nearest exposed point is farther than the surface over the closest core
    // point.
    const shapes_detail::RoundedSurfaceDistance surface_distance(tree, radius_, 2.0 * size_);
    for_each_in_chunks(scan_points_.size(), [&](std::size_t i) {
      const bool is_sample = i < count_;
      if (is_sample && pulls[i]->gap >= -kDeep * options_.target_distance) return;
      if (pulls[i]->gap < 0.0)
        pulls[i]->gap = surface_distance(scan_points_[i], scan_point_hints_[i]).value;
    });
    Pulls result;
    for (const std::optional<Pull>& pull : pulls) {
      if (!pull) continue;
      result.list.push_back(*pull);
      result.largest = std::max(result.largest, std::abs(pull->gap));
    }
    return result;
  }

  Vec3 position(const BodyPoint& point, const TriangleTree& tree) const {
    const auto& [a, b, c] = core_.mesh.triangles[point.triangle];
    return point.weights[0] * core_.mesh.vertices[a] + point.weights[1] * core_.mesh.vertices[b] +
           point.weights[2] * core_.mesh.vertices[c] +
           radius_ * point.direction.value_or(tree.outward_normal(point.triangle, point.feature));
  }

  /// Samples the faces by area, and each side and corner once.
  std::vector<BodyPoint> sample_body() const {
    std::vector<BodyPoint> points;
    std::vector<bool> has_corner(core_.mesh.vertices.size(), false);
    const TriangleTree tree(core_.mesh);
    std::uint32_t hint = 0;
    for (const Vec3& point : sample_surface(core_.mesh, count_)) {
      const TriangleTree::SignedClosest on_core = tree.signed_closest_point(point, hint);
      hint = on_core.triangle;
      points.push_back({on_core.triangle, on_core.weights});
    }
    for (std::uint32_t t = 0; t < core_.mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t from = core_.mesh.triangles[t][static_cast<std::size_t>(k)];
        const std::uint32_t to = core_.mesh.triangles[t][static_cast<std::size_t>((k + 1) % 3)];
        if (from < to) {
          points.push_back({t, 0.5 * (Vec3::Unit(k) + Vec3::Unit((k + 1) % 3)), 4 + k});
        }
        if (!has_corner[from]) points.push_back({t, Vec3::Unit(k), 1 + k});
        has_corner[from] = true;
      }
    }
    return points;
  }

  /// Adds points of both surfaces that are too far from the other surface, if one is farther than
  /// `max_distance`. Returns false if none is.
  bool add_distant_points() {
    shapes_detail::DeviationSearch search(scan_, core_.mesh, radius_, threads_);
    const auto [on_scan, on_body] =
        search.find_distant_points(options_.max_distance, options_.target_distance);
    scan_points_.insert(scan_points_.end(), on_scan.begin(), on_scan.end());
    for (const Vec3& point : on_body) {
      const TriangleTree::SignedClosest foot = search.core_tree().signed_closest_point(point);
      core_.points.push_back({foot.triangle, foot.weights, 0, foot.outward});
    }
    return !on_scan.empty() || !on_body.empty();
  }

  /// Newton's step for the sum of |gap|^power: that of weighted least squares over power - 1.
  std::vector<Vec3> steps(const Pulls& pulls, double power, double share) const {
    std::vector<Mat9> blocks(core_.mesh.triangles.size(), Mat9::Zero());
    std::vector<Vec9> sides(core_.mesh.triangles.size(), Vec9::Zero());
    for (const Pull& pull : pulls.list) {
      const double weight = std::pow(std::abs(pull.gap) / pulls.largest, power - 2.0);
      Vec9 row;
      row << pull.weights[0] * pull.direction, pull.weights[1] * pull.direction,
          pull.weights[2] * pull.direction;
      blocks[pull.triangle] += weight * row * row.transpose();
      sides[pull.triangle] += weight * pull.gap * row;
    }
    const std::size_t count = core_.mesh.vertices.size();
    const auto size = static_cast<Eigen::Index>(3 * count);
    double trace = 0.0;
    for (const Mat9& block : blocks) trace += block.trace();
    const double mean = trace / static_cast<double>(size);

    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(81 * blocks.size() + 6 * 12 * count);
    Eigen::VectorXd side = Eigen::VectorXd::Zero(size);
    for (std::size_t t = 0; t < blocks.size(); ++t) {
      const auto place = [&](int i) {
        const auto corner = core_.mesh.triangles[t][static_cast<std::size_t>(i / 3)];
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
    for (std::uint32_t t = 0; t < core_.mesh.triangles.size(); ++t) {
      const Vec3 before = unit_normal(core_.mesh, core_.mesh.triangles[t]);
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
    TriangleMesh collapsed = core_.mesh;
    if (collapse_triangle_edges(collapsed, bad) == 0) return false;
    if (!find_self_intersections(collapsed).empty()) return false;
    core_.mesh = std::move(collapsed);
    core_.points = sample_body();
    return true;
  }

  /// Takes the step, or as much of it as is possible. False: nothing is.
  bool move(std::vector<Vec3> step, int round) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      TriangleMesh moved = core_.mesh;
      for (std::size_t v = 0; v < step.size(); ++v) moved.vertices[v] += step[v];
      const std::vector<std::uint32_t> bad = in_the_way(moved);
      if (bad.empty()) {
        core_.mesh = std::move(moved);
        return true;
      }
      if (attempt == kShorterTries && may_collapse_ &&
          round + kRoundsAfterCollapse < options_.rounds && collapse(bad)) {
        return true;
      }
      std::vector<bool> held(step.size(), false);
      for (const std::uint32_t t : bad) {
        for (const std::uint32_t v : core_.mesh.triangles[t]) held[v] = true;
      }
      if (attempt <= kShorterTries) {
        for (std::size_t v = 0; v < step.size(); ++v) {
          if (held[v]) step[v] *= kShorter;
        }
        continue;
      }
      for (const auto& [a, b, c] : core_.mesh.triangles) {
        if (held[a] || held[b] || held[c]) step[a] = step[b] = step[c] = Vec3::Zero();
      }
    }
    return false;
  }

  const ScanSurface& scan_;
  double radius_, size_;
  CoreFitOptions options_;
  std::size_t count_;
  std::vector<Vec3> scan_points_;
  /// Triangles that were closest in the last round: of the core; of the core and the scan.
  std::vector<std::uint32_t> scan_point_hints_;
  std::vector<std::array<std::uint32_t, 2>> body_point_hints_;
  Core core_;
  ThreadPool threads_;
  bool may_collapse_ = true;  ///< until a core had to be given up
};

}  // namespace

void CoreFitOptions::check() const {
  if (rounds < 0) {
    throw InputError("rounds = " + std::to_string(rounds) + ": must be zero or more");
  }
  if (!(target_distance >= 0.0) || !(max_distance >= 0.0)) {
    throw InputError("target_distance = " + format_significant(target_distance, 6) +
                     " and max_distance = " + format_significant(max_distance, 6) +
                     ": must be zero or more");
  }
}

CoreFit fit_core(const ScanSurface& scan, const SpheroPolyhedron& start,
                 const CoreFitOptions& options) {
  options.check();
  if (start.faces.empty()) throw GeometryError("a core without faces can't be fitted to a scan");
  return Fit(scan, start, options).best();
}

}  // namespace clast

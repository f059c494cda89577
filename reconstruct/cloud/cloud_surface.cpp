#include "reconstruct/cloud/cloud_surface.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/cloud_normals.hpp"
#include "reconstruct/cloud/detail/cloud_uncertainty.hpp"
#include "reconstruct/cloud/detail/observed_surface.hpp"
#include "reconstruct/cloud/detail/poisson.hpp"
#include "reconstruct/cloud/local_surface.hpp"
#include "reconstruct/cloud/outliers.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/non_manifold_split.hpp"

namespace clast {

namespace {

constexpr double kClean = 0.05;  ///< noise over the distance of points that does not matter
/// Noise over the distance of points that is smoothed before normals have a side, and the
/// neighbours for normals among such points.
constexpr double kNoisy = 0.2;
constexpr int kNoisyNeighbours = 30;
/// The scatter of points is noise if twice the neighbours scatter by no more than this ratio, else
/// it is curvature; and if its kurtosis is no smaller than this, else it is that of a thin plate.
constexpr double kNoiseGrowth = 1.2, kNoiseKurtosis = 2.0;
constexpr double kCellNoises = 4.0;  ///< side of the cells in which smoothed points are averaged
using reconstruct_detail::NormalPropagation;

/// A way to normals that face outward.
struct NormalsBy {
  int neighbours = 0;
  NormalPropagation propagation = NormalPropagation::kParallel;
};

/// Order in which normals are tried: for decimated dense clouds, and for others.
constexpr std::array<NormalsBy, 4> kManyFirst = {
    {{18}, {10}, {30}, {10, NormalPropagation::kCircularArc}}};
constexpr std::array<NormalsBy, 4> kFewFirst = {
    {{10}, {10, NormalPropagation::kCircularArc}, {18}, {30}}};
/// Share of touching edges and of missed points for a surface through well-oriented points.
constexpr double kGood = 5e-4;
/// A point is missed where the surface is so many spacings away; where missed points stand for more
/// than this share of the area, the surface found is not that of the block.
constexpr double kMissed = 1.5, kMaxMissed = 0.01;
constexpr int kSurfaceRounds = 3;        ///< of surface and normals
constexpr std::size_t kFewWrong = 1000;  ///< points of which one normal may be wrong at first
constexpr double kCellSpacings = 2.0;    ///< a cell holds about four points at least
/// Points that lie closer about a plane than this share of their diagonal bound no body.
constexpr double kFlatCloud = 1e-3;

/// The volume is uncertain by so many times what halves of the points lack, by so many times what
/// the halves differ by, and by this share of the noise on all of the area.
constexpr double kSafety = 2.5, kScatters = 2.0, kNoiseFraction = 0.25;
/// Standard deviations of the noise by which each end of each side may be off.
constexpr double kExtremes = 2.0;
constexpr std::uint64_t kSeed = 1;

/// Standard deviation of the points about the plane, and about the line, that fits them best, m.
std::array<double, 2> thicknesses(std::span<const Vec3> points) {
  const auto count = static_cast<double>(points.size());
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += p / count;
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& p : points) scatter += (p - centre) * (p - centre).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter, Eigen::EigenvaluesOnly);
  const Vec3 squares = solver.eigenvalues().cwiseMax(0.0);
  return {std::sqrt(squares[0]), std::sqrt(squares[1])};
}

/// The solver for the surface fails on points without volume.
void refuse_flat(std::span<const Vec3> points, double diagonal) {
  const auto [plane, line] = thicknesses(points);
  if (plane > kFlatCloud * diagonal) return;
  const char* const what = !(diagonal > 0.0)              ? "at one point"
                           : line > kFlatCloud * diagonal ? "in a plane"
                                                          : "on a line";
  throw GeometryError(
      "all " + std::to_string(points.size()) + " points lie " + what +
      " and do not enclose a block; scan the block from all sides, and check which columns "
      "of the file are x, y and z");
}

/// Points about a body, and the closed surface through them.
struct Body {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  TriangleMesh surface;  ///< its vertices are the points
  std::size_t off = 0;   ///< points left out, which lay off the surface
  double noise = 0.0;    ///< standard deviation that was smoothed away, m
  std::unique_ptr<reconstruct_detail::IndicatorFunction> indicator;  ///< that gave the surface
  std::vector<double> spacings;                                      ///< of the points, m
  reconstruct_detail::ObservedSurface observed;  ///< which part of the surface the points explain
};

[[noreturn]] void refuse_no_surface(std::size_t points) {
  throw GeometryError("no surface was found through the " + std::to_string(points) +
                      " points; check that all lie on the surface of one block");
}

/// Alternates between both: the surface shows wrong normals, and corrected normals improve it.
/// @param spacings  of points without noise, to take in thin parts; else empty
/// @param wrong  normals that may be corrected without another surface
void find_surface(Body& body, std::span<const double> spacings, std::size_t wrong) {
  for (int round = 0; round < kSurfaceRounds; ++round) {
    body.indicator =
        std::make_unique<reconstruct_detail::IndicatorFunction>(body.points, body.normals);
    if (!body.indicator->is_solved()) refuse_no_surface(body.points.size());
    body.surface = reconstruct_detail::extract_surface(body.points, *body.indicator, spacings);
    if (body.surface.triangles.empty()) refuse_no_surface(body.points.size());
    if (reconstruct_detail::correct_normals(body.normals, body.surface) <= wrong) return;
  }
}

/// Leaves out the points that lie off the surface.
void remove_off_surface(Body& body) {
  const reconstruct_detail::MovingLeastSquares local(body.points, body.normals);
  const std::vector<bool> off =
      local.find_off_surface_points(reconstruct_detail::compute_local_spacings(body.points));
  Body kept;
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    if (off[i]) continue;
    kept.points.push_back(body.points[i]);
    kept.normals.push_back(body.normals[i]);
  }
  kept.off = body.points.size() - kept.points.size();
  body = std::move(kept);
}

/// Removes noise that is visible between neighbours, and with it real roughness of that size.
void smooth(Body& body, unsigned threads) {
  const reconstruct_detail::MovingLeastSquares local(body.points, body.normals);
  const double noise = local.estimate_noise();
  if (noise < kClean * reconstruct_detail::mean_spacing(body.points)) return;
  std::vector<Vec3> points = local.smoothed_points(noise, threads);
  body.points = std::move(points);
  body.noise = noise;
}

/// Smooths noise that is large compared with the point spacing, and averages the points at
/// distances where it is small. Returns its standard deviation; 0 if there is no such noise, and
/// the points are unchanged. Normals from so noisy points, and with them the surface, would be
/// wrong in places.
double smooth_large_noise(std::vector<Vec3>& points, unsigned threads) {
  const std::vector<Vec3> normals = reconstruct_detail::estimate_normals(points, kNoisyNeighbours);
  using reconstruct_detail::MovingLeastSquares;
  const MovingLeastSquares local(points, normals, false);
  const double noise = local.estimate_noise();
  if (noise < kNoisy * reconstruct_detail::mean_spacing(points)) return 0.0;
  const MovingLeastSquares::Scatter wider =
      local.estimate_scatter(2 * MovingLeastSquares::kNoiseNeighbours);
  if (wider.deviation > kNoiseGrowth * noise || wider.kurtosis < kNoiseKurtosis) return 0.0;
  points = reconstruct_detail::decimate_points(local.smoothed_points(noise, threads),
                                               kCellNoises * noise);
  return noise;
}

/// Edges where the surface touches itself, as a share of all. Where some normals face in, the
/// surface continues inside the body, and touches itself in many places.
double touching_share(const TriangleMesh& surface) {
  const MeshReport report = inspect_mesh(surface);
  return static_cast<double>(report.non_manifold_edges) / static_cast<double>(report.edges);
}

/// Points that the surface misses.
struct Missed {
  std::size_t count = 0;
  double fraction = 0.0;  ///< of the area that all points stand for
  Vec3 position = Vec3::Zero();
};

/// @param points  all, also those that were left out: where the surface is not the block's, these
///                are many and lie far apart
Missed missed_points(const TriangleMesh& surface, std::span<const Vec3> points) {
  const TriangleTree tree(surface);
  const std::vector<double> spacings = reconstruct_detail::compute_local_spacings(points);
  Missed missed;
  double all = 0.0, area = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double own = spacings[i] * spacings[i];
    all += own;
    if (std::sqrt(tree.closest_point(points[i]).squared_distance) < kMissed * spacings[i]) continue;
    ++missed.count;
    area += own;
    if (own <= largest) continue;
    largest = own;
    missed.position = points[i];
  }
  missed.fraction = area / all;
  return missed;
}

/// Fraction of the surface's area that the points do not explain.
double unseen_share(const Body& body) {
  double area = 0.0;
  for (std::size_t t = 0; t < body.observed.is_observed.size(); ++t) {
    if (!body.observed.is_observed[t])
      area += triangle_area(body.surface, body.surface.triangles[t]);
  }
  return area / surface_area(body.surface);
}

/// The surface through the points with their noise smoothed; of those that the ways to normals
/// give, the first that is as good as a surface, or the best.
Body body_through(const std::vector<Vec3>& points, std::span<const NormalsBy> ways,
                  const CloudSurfaceOptions& options) {
  Body best;
  Missed missed;
  double least = std::numeric_limits<double>::infinity();
  for (const NormalsBy& way : ways) {
    std::vector<Vec3> normals = reconstruct_detail::estimate_normals(points, way.neighbours);
    reconstruct_detail::orient_outward(normals, points, way.propagation);
    Body body{points, std::move(normals), {}, 0, 0.0, {}, {}, {}};
    find_surface(body, {}, points.size() / kFewWrong);  // only its normals are used
    remove_off_surface(body);
    smooth(body, options.threads);
    body.spacings = reconstruct_detail::compute_local_spacings(body.points);
    find_surface(body, body.spacings, 0);
    body.observed = reconstruct_detail::find_observed_surface(body.surface, body.spacings,
                                                              options.hole_ball_radius);
    const Missed left = missed_points(body.surface, points);
    const double defects = touching_share(body.surface) + left.fraction;
    // Wrong normals also make the surface span parts that it should follow.
    const double worse = defects + unseen_share(body);
    if (worse >= least) continue;
    least = worse;
    missed = left;
    best = std::move(body);
    if (defects <= kGood) break;
  }
  if (missed.fraction > kMaxMissed) {
    throw GeometryError(
        "the surface misses " + std::to_string(missed.count) + " of the " +
        std::to_string(points.size()) + " points, " +
        format_significant(100.0 * missed.fraction, 2) + " % of the area they cover, near " +
        format_point(missed.position) +
        ": these points belong to a second body that touches this one, or are too far apart for "
        "the thickness of the block; crop the cloud to one body, or scan it more "
        "densely there");
  }
  return best;
}

/// Adds to a margin how far the volume is uncertain. What triangles cut off between points, on
/// edges as on rounds, is to first order inversely proportional to the number of points: surfaces
/// through halves of them, drawn at random, lack as much again [richardson1911].
void add_volumes(SurfaceUncertainty& uncertainty, const Body& body) {
  Random random(kSeed);
  std::array<std::vector<Vec3>, 2> halves;
  for (const Vec3& p : body.points) halves[random.uniform_index(2)].push_back(p);
  const double whole = signed_volume(body.surface);
  std::array<double, 2> less{};
  for (std::size_t k = 0; k < 2; ++k) {
    const TriangleMesh surface = reconstruct_detail::extract_surface(
        halves[k], *body.indicator, reconstruct_detail::compute_local_spacings(halves[k]));
    less[k] = whole - signed_volume(surface);
  }
  const double mean = 0.5 * (less[0] + less[1]), apart = 0.5 * std::abs(less[0] - less[1]);
  const double rough = kNoiseFraction * body.noise * surface_area(body.surface);
  uncertainty.extent_error = kExtremes * body.noise;
  uncertainty.volume_above = kSafety * std::max(0.0, mean) + kScatters * apart + rough;
  uncertainty.volume_below = kSafety * std::max(0.0, -mean) + kScatters * apart + rough;
}

/// The largest component of what was seen; no triangles where nothing was.
TriangleMesh seen_part(const Body& body) {
  // Parted while it is closed: an edge of which both sheets lose a side would join the wrong ones.
  TriangleMesh closed = body.surface;
  const std::vector<std::uint32_t> source =
      reconstruct_detail::split_non_manifold_edges(closed).original_triangle;
  std::vector<bool> observed;
  for (const std::uint32_t t : source) observed.push_back(body.observed.is_observed[t]);
  TriangleMesh open = extract_triangles(closed, observed);
  reconstruct_detail::split_non_manifold_vertices(open);
  std::vector<reconstruct_detail::SurfaceComponent> components =
      reconstruct_detail::connected_components(open);
  return components.empty() ? TriangleMesh() : std::move(components.front().mesh);
}

}  // namespace

void CloudSurfaceOptions::check() const {
  const auto require = [](bool fine, const char* name, double value, const char* range) {
    if (fine) return;
    throw InputError(std::string(name) + " = " + format_significant(value, 4) + "; must be " +
                     range);
  };
  require(averaging_cell > 0.0 && averaging_cell <= 0.1, "cell", averaging_cell,
          "above 0 and at most 0.1");
  require(hole_ball_radius > 0.0, "trim", hole_ball_radius, "above 0");
}

CloudSurface fit_cloud_surface(std::span<const Vec3> points, const CloudSurfaceOptions& options) {
  options.check();
  if (points.size() < options.min_points) {
    throw InputError(std::to_string(points.size()) + " points are too few for a block; at least " +
                     std::to_string(options.min_points) + " are needed");
  }
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  refuse_flat(points, box.diagonal());
  const double cell = options.averaging_cell * box.diagonal();
  const bool dense = cell > kCellSpacings * reconstruct_detail::mean_spacing(points);
  std::vector<Vec3> averaged = dense ? reconstruct_detail::decimate_points(points, cell)
                                     : std::vector<Vec3>(points.begin(), points.end());
  const double noise = smooth_large_noise(averaged, options.threads);
  Body body = body_through(
      averaged,
      dense ? std::span<const NormalsBy>(kManyFirst) : std::span<const NormalsBy>(kFewFirst),
      options);
  body.noise = std::hypot(body.noise, noise);
  const reconstruct_detail::ObservedSurface& observed = body.observed;
  TriangleMesh open = seen_part(body);
  if (open.triangles.empty()) {
    throw GeometryError("the surface does not follow the " + std::to_string(points.size()) +
                        " points; check that all lie on the surface of one block, and clean the "
                        "cloud in CloudCompare");
  }
  SurfaceUncertainty uncertainty = reconstruct_detail::compute_surface_uncertainty(
      body.surface, {body.normals, body.spacings, body.noise});
  add_volumes(uncertainty, body);
  return {std::move(open), std::move(uncertainty), body.off,
          observed.gaps,   observed.gap_fraction,  observed.gap_position};
}

}  // namespace clast

#include "reconstruct/ground/ground.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"
#include "core/statistics/statistics.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/ground/detail/thin_plate_grid.hpp"

namespace clast {

namespace {

/// Cells over the diagonal. Planes are tried on one point per cell, so that points count by area.
constexpr double kGroundDecimationCell = 1.0 / 150.0;
/// Minimum fraction of the decimated points on a ground.
constexpr double kMinGroundFraction = 0.1;
/// Maximum fraction of the decimated points below a ground.
constexpr double kMaxBelow = 0.1;
/// Minimum area of ground visible around the objects on it, as a fraction of their plan area. A
/// flat side of a stone has no ground around it.
constexpr double kMinBeside = 0.3;
/// Minimum number, of eight sides of the largest object, on which ground is visible. A flat top
/// whose walls go down from its border has none.
constexpr int kMinSides = 3;
constexpr int kGridNodes = 32;      ///< of the local surface, along its longer side
constexpr double kStiffness = 1.0;  ///< of the local surface: it averages over about two cells
constexpr int kGroundFits = 8;      ///< of the local surface, each to a narrower band
constexpr double kNarrowing = 0.7;
constexpr double kBand = 3.0;  ///< of the roughness; beyond it a point is not on the ground
constexpr double kDeviationOfMad = 1.4826;
/// Minimum roughness over the tolerance, below that of any ground made by a program.
constexpr double kSmooth = 1e-6;

Plane plane_through(std::span<const Vec3> points) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += p / static_cast<double>(points.size());
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& p : points) scatter += (p - centre) * (p - centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter);
  const Vec3 normal = solver.eigenvectors().col(0);
  return {normal, normal.dot(centre)};
}

/// Numbers of decimated points on, above and below a plane.
struct Sides {
  std::size_t on = 0, above = 0, below = 0;
};

Sides sides_of(std::span<const Vec3> points, const Plane& plane, double tolerance) {
  Sides sides;
  for (const Vec3& p : points) {
    const double height = plane.signed_distance(p);
    sides.on += std::abs(height) < tolerance;
    sides.above += height > 3.0 * tolerance;
    sides.below += height < -3.0 * tolerance;
  }
  return sides;
}

Plane turned_up(Plane plane, std::span<const Vec3> points, double tolerance) {
  const Sides sides = sides_of(points, plane, tolerance);
  if (sides.below > sides.above) plane = {-plane.normal, -plane.distance};
  return plane;
}

/// Consensus of random triples; points on the smaller side count against a plane, twice.
Plane consensus_plane(std::span<const Vec3> points, double tolerance,
                      const GroundDetectionOptions& options) {
  Random random(options.seed);
  Plane best;
  double best_score = -1e300;
  for (int trial = 0; trial < options.trials; ++trial) {
    const auto draw = [&] { return points[random.uniform_index(points.size())]; };
    const Vec3 a = draw(), b = draw(), c = draw();
    const Vec3 normal = (b - a).cross(c - a);
    if (!(normal.norm() > 1e-3 * (b - a).norm() * (c - a).norm())) continue;
    const Plane plane{normal.normalized(), normal.normalized().dot(a)};
    const Sides sides = sides_of(points, plane, tolerance);
    const double score = static_cast<double>(sides.on) -
                         2.0 * static_cast<double>(std::min(sides.above, sides.below));
    if (score > best_score) {
      best_score = score;
      best = plane;
    }
  }
  // Least squares on the points it holds, until these stay the same.
  for (int i = 0; i < 10; ++i) {
    std::vector<Vec3> held;
    for (const Vec3& p : points) {
      if (std::abs(best.signed_distance(p)) < tolerance) held.push_back(p);
    }
    if (held.size() < 3) break;
    best = plane_through(held);
  }
  return turned_up(best, points, tolerance);
}

using PlanCell = std::pair<long, long>;

/// The largest set of cells that touch each other, corners included.
std::vector<PlanCell> largest_patch(std::set<PlanCell> cells) {
  std::vector<PlanCell> largest;
  while (!cells.empty()) {
    std::vector<PlanCell> patch = {*cells.begin()};
    cells.erase(cells.begin());
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const PlanCell at = patch[next];
      for (long dx = -1; dx <= 1; ++dx) {
        for (long dy = -1; dy <= 1; ++dy) {
          const auto found = cells.find({at.first + dx, at.second + dy});
          if (found == cells.end()) continue;
          patch.push_back(*found);
          cells.erase(found);
        }
      }
    }
    if (patch.size() > largest.size()) largest = std::move(patch);
  }
  return largest;
}

/// Counts the eight directions from the middle of `patch` in which cells of `on` lie beyond it.
int sides_with_more(const std::vector<PlanCell>& patch, const std::set<PlanCell>& on) {
  Vec2 middle = Vec2::Zero();
  for (const PlanCell& at : patch) {
    middle += Vec2(static_cast<double>(at.first), static_cast<double>(at.second)) /
              static_cast<double>(patch.size());
  }
  const auto polar = [&](const PlanCell& at) {
    const Vec2 from = Vec2(static_cast<double>(at.first), static_cast<double>(at.second)) - middle;
    const double turns = (std::atan2(from.y(), from.x()) + kPi) / (2.0 * kPi);
    return std::pair(std::min<std::size_t>(static_cast<std::size_t>(8.0 * turns), 7), from.norm());
  };
  std::array<double, 8> reach{};
  for (const PlanCell& at : patch) {
    const auto [side, distance] = polar(at);
    reach[side] = std::max(reach[side], distance);
  }
  std::array<bool, 8> more{};
  for (const PlanCell& at : on) {
    const auto [side, distance] = polar(at);
    more[side] |= distance > reach[side] + 1.0;
  }
  return static_cast<int>(std::count(more.begin(), more.end(), true));
}

/// True if enough of the plane is visible beside and around the objects above it.
bool goes_on_around(std::span<const Vec3> points, const Plane& plane, double tolerance,
                    double cell) {
  const Quat rotation = Quat::FromTwoVectors(plane.normal, Vec3::UnitZ());
  std::set<PlanCell> on, above;
  for (const Vec3& p : points) {
    const Vec3 flat = rotation * p;
    const PlanCell at(std::lround(flat.x() / cell), std::lround(flat.y() / cell));
    const double height = plane.signed_distance(p);
    if (height > 3.0 * tolerance) above.insert(at);
    if (std::abs(height) < tolerance) on.insert(at);
  }
  if (above.empty()) return true;
  const auto beside =
      std::count_if(on.begin(), on.end(), [&](const PlanCell& at) { return !above.contains(at); });
  return static_cast<double>(beside) > kMinBeside * static_cast<double>(above.size()) &&
         sides_with_more(largest_patch(above), on) >= kMinSides;
}

}  // namespace

struct Ground::Surface {
  Quat rotation;  ///< source axes to those of the plane
  Vec3 origin;    ///< of these, in source axes
  reconstruct_detail::ThinPlateGrid grid;

  Vec3 flat(const Vec3& point) const { return rotation * (point - origin); }
  double at(const Vec3& point) const { return grid.height_at(flat(point).head<2>()); }
};

Ground::Ground(const Plane& plane, std::unique_ptr<const Surface> surface, double roughness)
    : plane_(plane), surface_(std::move(surface)), roughness_(roughness) {}
Ground::Ground(Ground&&) noexcept = default;
Ground& Ground::operator=(Ground&&) noexcept = default;
Ground::~Ground() = default;

double Ground::height_above_ground(const Vec3& point) const {
  return surface_->flat(point).z() - surface_->at(point);
}

Plane Ground::tangent_plane_below(const Vec3& point, double size) const {
  const Surface& s = *surface_;
  const Vec2 at = s.flat(point).head<2>();
  const double d = 0.5 * size;
  const auto height = [&](double x, double y) { return s.grid.height_at(at + Vec2(x, y)); };
  const Vec3 normal =
      Vec3(height(-d, 0) - height(d, 0), height(0, -d) - height(0, d), 2.0 * d).normalized();
  const double mean = 0.25 * (height(-d, 0) + height(d, 0) + height(0, -d) + height(0, d));
  const Vec3 foot = s.origin + s.rotation.conjugate() * Vec3(at.x(), at.y(), mean);
  const Vec3 up = s.rotation.conjugate() * normal;
  return {up, up.dot(foot)};
}

void GroundDetectionOptions::check() const {
  if (trials < 1) throw InputError("trials = " + std::to_string(trials) + ": at least 1 is needed");
  if (!(tolerance > 0.0 && tolerance <= 0.1)) {
    throw InputError("tolerance = " + format_significant(tolerance, 4) +
                     ": must be a fraction of the diagonal, above 0 and at most 0.1");
  }
  if (!(min_block_height > 0.0 && min_block_height < 1.0)) {
    throw InputError("least_rise = " + format_significant(min_block_height, 4) +
                     ": must be a fraction of the diagonal, between 0 and 1");
  }
}

namespace {

/// Computes the roughness from single points, because decimation would smooth it.
double roughness_of(std::span<const Vec3> points, const Ground::Surface& surface,
                    double tolerance) {
  std::vector<double> heights;
  for (const Vec3& p : points) {
    heights.push_back(std::abs(surface.flat(p).z() - surface.at(p)));
  }
  double roughness = 0.0;
  for (double band = 2.0 * tolerance; band > std::max(kBand * roughness, kSmooth * tolerance);) {
    std::vector<double> within;
    for (const double height : heights) {
      if (height < band) within.push_back(height);
    }
    if (within.empty()) break;
    roughness = kDeviationOfMad * upper_median(std::move(within));
    if (kBand * roughness > kNarrowing * band) break;
    band *= kNarrowing;
  }
  return roughness;
}

}  // namespace

std::optional<Ground> find_ground(std::span<const Vec3> points,
                                  const GroundDetectionOptions& options) {
  options.check();
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  const double diagonal = points.empty() ? 0.0 : box.diagonal();
  const std::vector<Vec3> sparse =
      reconstruct_detail::decimate_points(points, kGroundDecimationCell * diagonal);
  if (sparse.size() < 50) return std::nullopt;
  const double tolerance = options.tolerance * diagonal;
  const Plane plane = consensus_plane(sparse, tolerance, options);
  const Sides sides = sides_of(sparse, plane, tolerance);
  const auto fraction = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(sparse.size());
  };
  if (fraction(sides.on) < kMinGroundFraction || fraction(sides.below) > kMaxBelow)
    return std::nullopt;
  if (!goes_on_around(sparse, plane, tolerance, 3.0 * kGroundDecimationCell * diagonal)) {
    return std::nullopt;
  }

  const Quat rotation = Quat::FromTwoVectors(plane.normal, Vec3::UnitZ());
  const Vec3 origin =
      plane.normal * plane.distance +
      (Mat3::Identity() - plane.normal * plane.normal.transpose()) * (0.5 * (box.low + box.high));
  std::vector<Vec3> flat;
  Eigen::AlignedBox2d extent;
  for (const Vec3& p : sparse) {
    flat.push_back(rotation * (p - origin));
    extent.extend(Vec2(flat.back().head<2>()));
  }
  // Fits narrower and narrower bands: walls are excluded, slow undulations included.
  std::vector<Vec3> held;
  std::optional<reconstruct_detail::ThinPlateGrid> grid;
  double band = 2.0 * tolerance, roughness = 0.0;
  for (int fit = 0; fit < kGroundFits; ++fit) {
    held.clear();
    for (const Vec3& p : flat) {
      if (std::abs(p.z() - (grid ? grid->height_at(p.head<2>()) : 0.0)) < band) held.push_back(p);
    }
    if (held.size() < 10) return std::nullopt;
    grid.emplace(held, extent, kGridNodes, kStiffness);
    std::vector<double> off;
    for (const Vec3& p : held) off.push_back(std::abs(p.z() - grid->height_at(p.head<2>())));
    roughness = kDeviationOfMad * upper_median(std::move(off));
    band = std::max(kBand * roughness, kNarrowing * band);
  }
  auto surface = std::make_unique<const Ground::Surface>(Ground::Surface{rotation, origin, *grid});
  roughness = roughness_of(points, *surface, tolerance);
  return Ground(plane, std::move(surface), roughness);
}

}  // namespace clast

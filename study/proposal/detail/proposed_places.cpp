// Release points and a barrier, proposed from the shape of a terrain.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/proposal/new_campaign.hpp"

namespace clast {
namespace {

constexpr double kSteps = 150.0;    ///< along the longer side of the terrain
constexpr double kMinSteps = 12.0;  ///< along the shorter one
constexpr int kStartsPerSide = 40;  ///< that are tried, in a grid over the terrain
constexpr double kBorderMarginFraction =
    0.04;  ///< of the terrain, that releases keep from its border
/// Degrees: below the first no block starts; ground steeper than the second is no better.
constexpr double kGentlestStart = 10.0, kSteepStart = 55.0;
constexpr double kNearlyBest = 0.9;    ///< of the best start is as good
constexpr double kLineFraction = 0.6;  ///< of the slope at the start, that its neighbours need
constexpr std::size_t kMaxReleasePoints = 5;
/// Apparent, of the whole path: an energy line of 33 degrees. On gentle terrain it is this share of
/// the steepest slope, so that the point moves at all.
constexpr double kFrictionRange = 0.65, kGentleFraction = 0.75;
constexpr double kStartHead = 1.0;            ///< m of fall that the point has at its start
constexpr double kLargestHead = 20.0;         ///< m: blocks are seldom faster than 20 m/s
constexpr std::size_t kMaxPathLength = 2000;  ///< steps
constexpr double kFootFraction = 0.7;  ///< of the descent lies above the foot of a slope at least
constexpr double kLateFoot = 0.85;     ///< of the way, where a slope has no foot
constexpr double kBarrierFraction = 0.35;  ///< of the way, half the length of the barrier

double tangent(double degrees) { return std::tan(degrees * kRadiansPerDegree); }

/// The uppermost ground, seen in steps of one length; local frame, m.
struct UpperGround {
  const TerrainSurface& surface;
  double step = 0.0;

  UpperGround(const TerrainSurface& ground, double block_length) : surface(ground) {
    const Vec2 size = (ground.extent().high - ground.extent().low).head<2>();
    step = std::min(std::max(size.maxCoeff() / kSteps, block_length / 2.0),
                    size.minCoeff() / kMinSteps);
    step = std::max(step, size.maxCoeff() / static_cast<double>(kMaxPathLength));
  }

  std::optional<double> height(const Vec2& place) const {
    return surface.height_at(place.x(), place.y(), surface.extent().high.z() + 1.0);
  }

  /// Gradient of the plane through nine places, a step apart: it points uphill and is as long as
  /// the tangent of the slope. None where one of them is off the ground.
  std::optional<Vec2> gradient(const Vec2& place) const {
    Vec2 gradient = Vec2::Zero();
    for (const double i : {-1.0, 0.0, 1.0}) {
      for (const double j : {-1.0, 0.0, 1.0}) {
        const std::optional<double> z = height(place + step * Vec2(i, j));
        if (!z) return std::nullopt;
        gradient += *z / (6.0 * step) * Vec2(i, j);
      }
    }
    return gradient;
  }

  /// True if the square of this half width around the place lies on the ground.
  bool covers(const Vec2& place, double half_width) const {
    const double count = std::ceil(half_width / step);
    for (double i = -count; i <= count; ++i) {
      for (double j = -count; j <= count; ++j) {
        const Vec2 at = place + half_width / count * Vec2(i, j);
        if (!surface.covers(at.x(), at.y())) return false;
      }
    }
    return true;
  }
};

/// Path of a point mass that starts at rest and slides down against friction, deflected by the
/// ground, one point a step. It ends where the point stops or the ground does.
std::vector<Vec3> fall_path(const UpperGround& ground, const Vec2& start, double friction) {
  std::vector<Vec3> path;
  Vec2 place = start, direction = Vec2::Zero();
  double head = kStartHead;
  while (path.size() < kMaxPathLength) {
    const std::optional<Vec2> uphill = ground.gradient(place);
    if (!uphill) break;
    const double z = *ground.height(place);
    if (path.empty()) {
      direction = -uphill->normalized();
    } else {
      head += path.back().z() - z - friction * ground.step;
      if (!(head > 0.0)) break;
      head = std::min(head, kLargestHead);
    }
    path.emplace_back(place.x(), place.y(), z);
    // The gradient across the path curves it by 1 / (2 head) per metre.
    const Vec2 across = *uphill - uphill->dot(direction) * direction;
    direction -= across * (ground.step / (2.0 * std::max(head, ground.step)));
    direction.normalize();
    place += ground.step * direction;
  }
  return path;
}

double descent_of(const std::vector<Vec3>& path) { return path.front().z() - path.back().z(); }

/// A place where blocks could start.
struct Start {
  Vec2 position = Vec2::Zero();
  Vec2 uphill = Vec2::Zero();  ///< gradient of the ground
  std::vector<Vec3> path = {};
};

/// Places in a grid over the terrain with this margin to the border.
std::vector<Start> starts_with(const UpperGround& ground, double margin) {
  const Bounds& box = ground.surface.extent();
  const Vec2 low = box.low.head<2>(), apart = (box.high - box.low).head<2>() / kStartsPerSide;
  std::vector<Start> starts;
  for (int i = 0; i < kStartsPerSide; ++i) {
    for (int j = 0; j < kStartsPerSide; ++j) {
      const Vec2 place = low + apart.cwiseProduct(Vec2(i + 0.5, j + 0.5));
      const std::optional<Vec2> uphill = ground.gradient(place);
      if (uphill && ground.covers(place, margin)) starts.push_back({place, *uphill});
    }
  }
  return starts;
}

/// The middle one of the starts from which blocks go furthest down off steep ground.
/// @throws InputError  all ground is too gentle
Start best_start(const UpperGround& ground, std::vector<Start> starts) {
  double steepest = 0.0, best = 0.0;
  for (const Start& start : starts) steepest = std::max(steepest, start.uphill.norm());
  if (steepest < tangent(kGentlestStart)) {
    throw InputError("the steepest ground of the terrain slopes " +
                     format_decimals(std::atan(steepest) * kDegreesPerRadian, 1) +
                     " degrees, on which no block starts; add the slope above it, or write the "
                     "campaign by hand, with velocity_m_s in [release]");
  }
  const auto merit = [](const Start& start) {
    return descent_of(start.path) * std::min(start.uphill.norm(), tangent(kSteepStart));
  };
  for (Start& start : starts) {
    start.path =
        fall_path(ground, start.position, std::min(kFrictionRange, kGentleFraction * steepest));
    best = std::max(best, merit(start));
  }
  std::erase_if(starts, [&](const Start& start) { return merit(start) < kNearlyBest * best; });
  Vec2 middle = Vec2::Zero();
  for (const Start& start : starts) middle += start.position / static_cast<double>(starts.size());
  return *std::min_element(starts.begin(), starts.end(), [&](const Start& a, const Start& b) {
    return (a.position - middle).squaredNorm() < (b.position - middle).squaredNorm();
  });
}

/// Largest distance from a position, both ways, at which `good` holds; at most `most`.
template <typename Good>
double reach(const Vec2& place, const Vec2& direction, double step, double maximum,
             const Good& good) {
  double way = 0.0;
  while (way + step <= maximum && good(place + (way + step) * direction) &&
         good(place - (way + step) * direction)) {
    way += step;
  }
  return way;
}

/// Distance in the plan to the foot of the slope: where the profile lies deepest below the straight
/// line from start to end, once most of the descent is done; late on the way where it is straight.
double distance_to_foot(const std::vector<Vec3>& path) {
  const double last = static_cast<double>(path.size() - 1), descent = descent_of(path);
  std::size_t foot = static_cast<std::size_t>(kLateFoot * last);
  double deepest = 0.05 * descent;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double fallen = path.front().z() - path[i].z();
    const double below = fallen - descent * static_cast<double>(i) / last;
    if (fallen < kFootFraction * descent || below <= deepest) continue;
    deepest = below;
    foot = i;
  }
  return (path[foot] - path.front()).head<2>().norm();
}

/// The line through a place, on the map.
ProposedLine line_through(const UpperGround& ground, const MapFrame& frame, const Vec2& place,
                          const Vec2& half) {
  const auto on_map = [&](const Vec2& at) {
    return frame.to_map({at.x(), at.y(), ground.height(at).value_or(0.0)});
  };
  return {on_map(place - half), on_map(place + half)};
}

}  // namespace

ProposedReleaseAndBarrier propose_release_and_barrier(const Terrain& terrain,
                                                      const TerrainSurface& surface,
                                                      double block_length) {
  const UpperGround ground(surface, block_length);
  ProposedReleaseAndBarrier places;
  places.block_length = block_length;
  places.margin = std::max(
      2.0 * block_length,
      kBorderMarginFraction * (surface.extent().high - surface.extent().low).head<2>().maxCoeff());
  std::vector<Start> starts = starts_with(ground, places.margin);
  if (starts.empty()) starts = starts_with(ground, places.margin = block_length);
  if (starts.empty()) {
    throw InputError("no point of the terrain is as far from its border as blocks of " +
                     format_significant(block_length, 3) +
                     " m are long; check the units of scans and terrain, or survey more of it");
  }
  const Start start = best_start(ground, std::move(starts));
  places.path = start.path;
  if (places.path.size() < 3) {
    throw InputError(
        "no path leads downslope from the steepest ground of the terrain; check that it is not a "
        "pit");
  }
  const double steep = start.uphill.norm();
  places.release_slope = std::atan(steep);
  const Vec2 across = Vec2(-start.uphill.y(), start.uphill.x()) / steep;
  const auto good = [&](const Vec2& place) {
    const std::optional<Vec2> uphill = ground.gradient(place);
    return uphill && ground.covers(place, places.margin) &&
           uphill->norm() >= kLineFraction * std::min(steep, tangent(kSteepStart));
  };
  const double apart = 2.0 * block_length;
  const double way = (places.path.back() - places.path.front()).head<2>().norm();
  const double half = reach(start.position, across, std::min(apart, ground.step),
                            std::max(2.0 * apart, 0.1 * way), good);
  places.release_points =
      std::min(kMaxReleasePoints, 1 + static_cast<std::size_t>(2.0 * half / apart));
  places.releases = line_through(ground, terrain.frame, start.position,
                                 (places.release_points > 1 ? half : 0.0) * across);
  place_barrier(terrain, surface, distance_to_foot(places.path), places);
  return places;
}

void place_barrier(const Terrain& terrain, const TerrainSurface& surface, double distance,
                   ProposedReleaseAndBarrier& places) {
  const UpperGround ground(surface, places.block_length);
  const std::vector<Vec3>& path = places.path;
  const double clear = std::max(places.block_length, ground.step);
  const auto way_to = [&](std::size_t i) -> Vec2 { return (path[i] - path.front()).head<2>(); };
  std::size_t at = 1;
  while (at + 1 < path.size() && way_to(at + 1).norm() <= distance &&
         ground.covers(path[at + 1].head<2>(), clear)) {
    ++at;
  }
  places.distance = way_to(at).norm();
  places.descent = path.front().z() - path[at].z();
  places.downslope = way_to(at) / places.distance;
  // Blocks that come down see its first point on their left.
  const Vec2 place = path[at].head<2>(), left(-places.downslope.y(), places.downslope.x());
  const double releases = (places.releases.to - places.releases.from).head<2>().norm();
  const double half = reach(
      place, left, ground.step,
      std::max(kBarrierFraction * places.distance, 0.5 * releases + 2.0 * places.block_length),
      [&](const Vec2& spot) { return surface.covers(spot.x(), spot.y()); });
  places.barrier = line_through(ground, terrain.frame, place, std::max(clear, half) * left);
}

}  // namespace clast

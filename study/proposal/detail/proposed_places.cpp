// Release points and a barrier, proposed on a terrain.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/proposal/detail/fall_paths.hpp"
#include "study/proposal/new_campaign.hpp"

namespace clast {

using namespace study_detail;
namespace {

/// Slopes that are tried, steepest first: blocks start by themselves on the first two, on the first
/// also where mu is 0.7 and more, and below the last they come to rest where they land.
constexpr std::array<double, 7> kSlopes = {38.0, 35.0, 30.0, 25.0, 20.0, 15.0, 10.0};  // degrees
constexpr double kUpperShare = 0.7;  ///< of the longest descent, from ground as steep as that
constexpr double kBorderMarginShare = 0.04;  ///< of the terrain, that releases keep from its border
/// Apparent, of the whole way down, highest first: what blocks that hardly roll overcome goes for
/// all.
constexpr std::array<double, 5> kFrictions = {0.75, 0.65, 0.5, 0.35, 0.15};
constexpr double kFootFriction = 0.65;     ///< at most, for a way that goes on beyond the foot
constexpr double kReliefShare = 0.4;       ///< of the terrain's relief, that a way down should have
constexpr std::size_t kMostStarts = 4000;  ///< tried
constexpr double kNearlyBest = 0.9;        ///< of the longest descent is as good
constexpr std::size_t kMostReleasePoints = 5;
constexpr double kFootShare = 0.7;      ///< of the descent lies above the foot of a slope at least
constexpr double kLateFoot = 0.85;      ///< of the way, where a slope has no foot
constexpr double kBarrierShare = 0.35;  ///< of the way, half the length of the barrier

struct Start {
  Vec2 place = Vec2::Zero();
  double slope = 0.0;    ///< tangent
  double descent = 0.0;  ///< of its fall path, m
};

/// Ground with this margin, thinned to what can be tried.
std::vector<Start> starts_with(const GroundGrid& grid, double margin) {
  std::vector<Start> starts;
  for (std::uint32_t row = 0; row < grid.rows(); ++row) {
    for (std::uint32_t column = 0; column < grid.columns(); ++column) {
      const Vec2 place = grid.centre(column, row);
      if (!grid.covered(place, margin)) continue;
      if (const auto ground = grid.slope(place)) {
        starts.push_back({place, ground->gradient.norm()});
      }
    }
  }
  return starts;
}

double tangent(double degrees) { return std::tan(degrees * kRadiansPerDegree); }

double descent_of(const std::vector<Vec3>& path) {
  return path.empty() ? 0.0 : path.front().z() - path.back().z();
}

double longest_descent(const std::vector<Start>& starts) {
  double longest = 0.0;
  for (const Start& start : starts) longest = std::max(longest, start.descent);
  return longest;
}

/// Follows the ways down from at most `kMostStarts` of the starts, which are left.
/// @return the friction of these ways: the highest at which one is long on this terrain
double follow(std::vector<Start>& starts, const GroundGrid& grid, double relief) {
  const std::size_t stride = 1 + starts.size() / kMostStarts;
  std::vector<Start> tried;
  for (std::size_t i = 0; i < starts.size(); i += stride) tried.push_back(starts[i]);
  starts = std::move(tried);
  for (const double friction : kFrictions) {
    for (Start& start : starts) start.descent = descent_of(fall_path(grid, start.place, friction));
    if (longest_descent(starts) >= kReliefShare * relief) return friction;
  }
  return kFrictions.back();
}

/// Starts on the steepest ground from which most of the longest descent is possible.
/// @return the tangent of that slope
double keep_steep(std::vector<Start>& starts) {
  const double least = kUpperShare * longest_descent(starts);
  for (const double degrees : kSlopes) {
    const double steep = tangent(degrees);
    std::vector<Start> some;
    std::copy_if(starts.begin(), starts.end(), std::back_inserter(some),
                 [&](const Start& start) { return start.slope >= steep; });
    if (some.empty() || longest_descent(some) < least) continue;
    starts = std::move(some);
    return steep;
  }
  return tangent(kSlopes.back());
}

/// Of the starts whose way down is nearly the longest, the one in their middle.
Start best_of(std::vector<Start> starts) {
  const double least = kNearlyBest * longest_descent(starts);
  std::erase_if(starts, [&](const Start& start) { return start.descent < least; });
  Vec2 middle = Vec2::Zero();
  for (const Start& start : starts) middle += start.place / static_cast<double>(starts.size());
  return *std::min_element(starts.begin(), starts.end(), [&](const Start& a, const Start& b) {
    return (a.place - middle).squaredNorm() < (b.place - middle).squaredNorm();
  });
}

/// How far one can go from `from` along `direction` and stay where `good` holds, at most `most`.
template <typename Good>
double reach(const Vec2& from, const Vec2& direction, double step, double most, const Good& good) {
  double way = 0.0;
  while (way + step <= most && good(Vec2(from + (way + step) * direction))) way += step;
  return way;
}

/// The foot of the slope: where the profile lies deepest below the straight line from start to end,
/// once most of the descent is done; late on the way where it is straight.
std::size_t foot_of(const std::vector<Vec3>& path) {
  const std::size_t last = path.size() - 1;
  const std::size_t late = static_cast<std::size_t>(kLateFoot * static_cast<double>(last));
  std::size_t foot = late;
  double deepest = 0.05 * descent_of(path);
  for (std::size_t i = 1; i < last; ++i) {
    if (path.front().z() - path[i].z() < kFootShare * descent_of(path)) continue;
    const double share = static_cast<double>(i) / static_cast<double>(last);
    const double below = path.front().z() - share * descent_of(path) - path[i].z();
    if (below <= deepest) continue;
    deepest = below;
    foot = i;
  }
  return std::max<std::size_t>(foot, 1);
}

MapPoint on_map(const Terrain& terrain, const GroundGrid& grid, const Vec2& place) {
  const auto ground = grid.slope(place);
  return terrain.frame.map({place.x(), place.y(), ground ? ground->height : 0.0});
}

/// Points on a line through the start, across the slope.
void propose_releases(const Terrain& terrain, const GroundGrid& grid, const Start& start,
                      double way, double steep, ProposedPlaces& places) {
  const Vec2 uphill = grid.slope(start.place)->gradient.normalized();
  const Vec2 across(-uphill.y(), uphill.x());
  const double apart = 2.0 * places.block_length;
  const auto good = [&](const Vec2& place) {
    const auto ground = grid.slope(place);
    return ground && grid.covered(place, places.margin) && ground->gradient.norm() >= 0.8 * steep;
  };
  const double step = std::min(apart, grid.cell()), most = std::max(2.0 * apart, 0.1 * way);
  const double right = reach(start.place, across, step, most, good);
  const double left = reach(start.place, Vec2(-across), step, most, good);
  places.release_from = on_map(terrain, grid, start.place - left * across);
  places.release_to = on_map(terrain, grid, start.place + right * across);
  places.release_points =
      std::min(kMostReleasePoints, 1 + static_cast<std::size_t>((left + right) / apart));
  if (places.release_points > 1) return;
  places.release_from = places.release_to = on_map(terrain, grid, start.place);
}

void place_barrier_at(const Terrain& terrain, const GroundGrid& grid, std::size_t at,
                      ProposedPlaces& places) {
  const std::vector<Vec3>& path = places.way_down;
  const double clear = std::max(places.block_length, grid.cell());
  while (at > 1 && !grid.covered(path[at].head<2>(), clear)) --at;
  const Vec2 start = path.front().head<2>(), place = path[at].head<2>();
  places.distance = (place - start).norm();
  places.descent = path.front().z() - path[at].z();
  if (places.distance > 0.0) places.downslope = (place - start) / places.distance;
  const Vec2 left(-places.downslope.y(), places.downslope.x());
  const double releases = (places.release_to - places.release_from).head<2>().norm();
  const double most =
      std::max(kBarrierShare * places.distance, 0.5 * releases + 2.0 * places.block_length);
  const auto ground = [&](const Vec2& spot) { return grid.covered(spot, 0.0) && grid.slope(spot); };
  const double to_left = std::max(clear, reach(place, left, grid.cell(), most, ground));
  const double to_right = std::max(clear, reach(place, Vec2(-left), grid.cell(), most, ground));
  // Blocks that come down see its first point on their left.
  places.barrier_from = on_map(terrain, grid, place - to_right * left);
  places.barrier_to = on_map(terrain, grid, place + to_left * left);
}

GroundGrid grid_of(const Terrain& terrain, double block_length) {
  const Bounds box = bounds(terrain.surface);
  const double extent = (box.high - box.low).head<2>().maxCoeff();
  return GroundGrid(terrain, std::max(extent / 150.0, block_length / 2.0));
}

}  // namespace

ProposedPlaces propose_places(const Terrain& terrain, double block_length) {
  const Bounds box = bounds(terrain.surface);
  const double extent = (box.high - box.low).head<2>().maxCoeff();
  const GroundGrid grid = grid_of(terrain, block_length);
  ProposedPlaces places;
  places.block_length = block_length;
  places.margin = std::max(2.0 * block_length, kBorderMarginShare * extent);
  std::vector<Start> starts = starts_with(grid, places.margin);
  while (starts.empty() && places.margin > block_length) {
    places.margin = std::max(block_length, places.margin / 2.0);
    starts = starts_with(grid, places.margin);
  }
  if (starts.empty()) {
    throw InputError("no place of the terrain is as far from its border as blocks of " +
                     with_digits(block_length, 3) +
                     " m are long; check the units of scans and terrain, or survey more of it");
  }
  const double steepest =
      std::max_element(starts.begin(), starts.end(), [](const Start& a, const Start& b) {
        return a.slope < b.slope;
      })->slope;
  if (steepest < tangent(kSlopes.back())) {
    throw InputError("the steepest ground of the terrain has " +
                     with_decimals(std::atan(steepest) * kDegreesPerRadian, 1) +
                     " degrees, on which no block starts; add the slope above it, or write the "
                     "campaign by hand, with velocity_m_s in [release]");
  }
  std::erase_if(starts, [](const Start& start) { return start.slope < tangent(kSlopes.back()); });
  const double friction = follow(starts, grid, box.high.z() - box.low.z());
  const double steep = keep_steep(starts);
  const Start start = best_of(std::move(starts));
  places.way_down = fall_path(grid, start.place, std::min(friction, kFootFriction));
  if (places.way_down.size() < 3) {
    throw InputError("at the steepest ground of the terrain there is no way down; is it a pit?");
  }
  const double way = (places.way_down.back() - places.way_down.front()).head<2>().norm();
  places.release_slope = std::atan(start.slope);
  propose_releases(terrain, grid, start, way, steep, places);
  place_barrier_at(terrain, grid, foot_of(places.way_down), places);
  return places;
}

void place_barrier(const Terrain& terrain, double distance, ProposedPlaces& places) {
  const std::vector<Vec3>& path = places.way_down;
  std::size_t at = 1;
  while (at + 1 < path.size() && (path[at + 1] - path.front()).head<2>().norm() <= distance) ++at;
  place_barrier_at(terrain, grid_of(terrain, places.block_length), at, places);
}

}  // namespace clast

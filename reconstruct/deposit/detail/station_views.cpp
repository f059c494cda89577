#include "reconstruct/deposit/detail/station_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics/statistics.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kSightRadius = 1.3;  ///< of points around a line of sight, in their spacings
constexpr std::size_t kMinSightPoints = 4;
constexpr double kSightMargin = 2.0;   ///< least distance of free space from points, in spacings
constexpr double kSearchRadius = 2.0;  ///< around a line of sight, in spacings at the position
constexpr double kSightCellSpacings = 2.0;  ///< side of a cell, in median angles between points
constexpr double kLeastCell = 1e-4;         ///< in the octahedral map
constexpr std::size_t kMaxStations = 12;

/// Maps a direction to a square with the sides 2, centred on the direction downwards. Only
/// directions upwards are divided by its border.
Vec2 octahedral_map(const Vec3& direction) {
  const Vec3 d = direction / direction.cwiseAbs().sum();
  if (d.z() <= 0.0) return d.head<2>();
  return {std::copysign(1.0 - std::abs(d.y()), d.x()), std::copysign(1.0 - std::abs(d.x()), d.y())};
}

/// Column or row of a coordinate of the map.
std::uint32_t index_along(double coordinate, double side) {
  return static_cast<std::uint32_t>((std::clamp(coordinate, -1.0, 1.0) + 1.0) / side);
}

/// Chooses stations that are far from each other and from those chosen before, the first one first.
std::vector<Vec3> choose_spread_stations(std::span<const Vec3> stations) {
  std::vector<Vec3> chosen;
  std::vector<double> distances(stations.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < std::min(stations.size(), kMaxStations)) {
    const auto farthest = std::max_element(distances.begin(), distances.end());
    chosen.push_back(stations[static_cast<std::size_t>(farthest - distances.begin())]);
    for (std::size_t s = 0; s < stations.size(); ++s) {
      distances[s] = std::min(distances[s], (stations[s] - chosen.back()).norm());
    }
  }
  return chosen;
}

}  // namespace

StationViews::StationViews(const OrientedPoints& cloud, std::span<const Vec3> stations)
    : cloud_(cloud) {
  for (const Vec3& station : choose_spread_stations(stations)) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double distance = (cloud.positions[i] - station).norm();
      if (distance > 0.0) angles.push_back(cloud.spacings[i] / distance);
    }
    if (angles.empty()) continue;
    View view{
        station, std::max(kLeastCell, kSightCellSpacings * upper_median(std::move(angles))), 0, {}};
    view.columns = index_along(1.0, view.cell_side) + 1;
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
      const Vec3 ray = cloud.positions[i] - station;
      if (!(ray.norm() > 0.0)) continue;
      const Vec2 place = octahedral_map(ray);
      view.entries.push_back({index_along(place.x(), view.cell_side) +
                                  view.columns * index_along(place.y(), view.cell_side),
                              i});
    }
    std::sort(view.entries.begin(), view.entries.end(), [](const Entry& a, const Entry& b) {
      return a.cell != b.cell ? a.cell < b.cell : a.point < b.point;
    });
    views_.push_back(std::move(view));
  }
}

bool StationViews::is_free(const Vec3& position, double spacing) const {
  return std::any_of(views_.begin(), views_.end(),
                     [&](const View& view) { return is_free(view, position, spacing); });
}

bool StationViews::is_free(const View& view, const Vec3& position, double spacing) const {
  const Vec3 ray = position - view.station;
  const double distance = ray.norm();
  if (!(distance > kSightMargin * spacing)) return false;
  const Vec3 direction = ray / distance;
  const Vec2 place = octahedral_map(ray);
  const double reach = kSearchRadius * spacing / distance;
  const std::uint32_t first = index_along(place.x() - reach, view.cell_side);
  const std::uint32_t last = index_along(place.x() + reach, view.cell_side);
  const std::uint32_t highest = index_along(place.y() + reach, view.cell_side);
  std::size_t behind = 0;
  for (std::uint32_t row = index_along(place.y() - reach, view.cell_side); row <= highest; ++row) {
    auto entry =
        std::lower_bound(view.entries.begin(), view.entries.end(), view.columns * row + first,
                         [](const Entry& e, std::uint32_t cell) { return e.cell < cell; });
    for (; entry != view.entries.end() && entry->cell <= view.columns * row + last; ++entry) {
      const Vec3 seen = cloud_.positions[entry->point] - view.station;
      const double depth = seen.dot(direction), h = cloud_.spacings[entry->point];
      if (!(depth > 0.0) || (seen - depth * direction).norm() > kSightRadius * h) continue;
      if (depth < distance + kSightMargin * std::max(h, spacing)) return false;
      if (cloud_.normals[entry->point].dot(direction) < 0.0) ++behind;
    }
  }
  return behind >= kMinSightPoints;
}

}  // namespace clast::reconstruct_detail

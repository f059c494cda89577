#include "report/maps/map_window.hpp"

#include <algorithm>
#include <cmath>

#include "core/files/png.hpp"
#include "core/nice_number.hpp"
#include "study/campaign/barrier_line.hpp"

namespace clast::report_detail {
namespace {

constexpr double kNarrowest = 0.45;  // height over width of the window, and the other way round

void include(Window& window, const Vec2& point) {
  if (!point.allFinite()) return;
  window.low = window.low.cwiseMin(point);
  window.high = window.high.cwiseMax(point);
}

}  // namespace

Window map_window(const Comparison& comparison) {
  Window window{Vec2::Constant(INFINITY), Vec2::Constant(-INFINITY)};
  for (const RunRow& row : comparison.rows) {
    include(window, row.start.head<2>());
    if (row.record->result.stop_reason != StopReason::kError) include(window, row.stop.head<2>());
  }
  for (const BarrierLine& line : comparison.lines) {
    for (const Vec2& point : line.through) include(window, point);
  }
  if (comparison.measured) {
    for (const MeasuredStop& stop : comparison.measured->stops) include(window, stop.place);
  }
  if (comparison.groups.empty()) {  // a plan: where blocks may go is not known
    const CampaignResults& first = comparison.results.front();
    for (const Vec3& vertex : first.terrain.surface.vertices) {
      include(window, first.frame.map(vertex).head<2>());
    }
  }
  const double longer = std::max(window.size().maxCoeff(), 4.0);
  const Vec2 middle = 0.5 * (window.low + window.high);
  Vec2 size = window.size() + Vec2::Constant(0.14 * longer);
  size = size.cwiseMax(kNarrowest * size.maxCoeff());
  return {middle - 0.5 * size, middle + 0.5 * size};
}

CountArrow count_arrow(const BarrierLine& line) {
  using Counts = BarrierLine::Counts;
  // The two arrows of a ring stand at different sides.
  const std::size_t side = line.counts == Counts::kExits ? 0 : (line.through.size() - 1) / 2;
  const Vec2 &from = line.through[side], &to = line.through[side + 1];
  const Vec2 along = (to - from).normalized();
  const Vec2 to_right(along.y(), -along.x());
  const bool right =
      !line.of_ring() || inside_is_left(line.through) == (line.counts == Counts::kExits);
  return {0.5 * (from + to), right ? to_right : Vec2(-to_right), line.counts == Counts::kEither};
}

double contour_interval(const Comparison& comparison) {
  double low = INFINITY, high = -INFINITY;
  if (comparison.groups.empty()) {
    const CampaignResults& first = comparison.results.front();
    for (const Vec3& vertex : first.terrain.surface.vertices) {
      low = std::min(low, vertex.z());
      high = std::max(high, vertex.z());
    }
  }
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    low = std::min({low, row.start.z(), row.stop.z()});
    high = std::max({high, row.start.z(), row.stop.z()});
  }
  return std::max(0.1, round_up_to_nice((high - low) / 12.0));
}

std::string relief_image(const Comparison& comparison, const Window& window, std::uint32_t columns,
                         double interval) {
  const CampaignResults& first = comparison.results.front();
  const Vec2 origin = first.frame.origin.head<2>();
  const Relief relief =
      sampled(first.terrain, {window.low - origin, window.high - origin}, columns);
  return png_link(relief_png(relief, first.terrain.zone_names, first.frame.origin.z(), interval));
}

}  // namespace clast::report_detail

#include "report/maps/site_map.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/nice_number.hpp"
#include "core/number_text.hpp"
#include "report/charts/contour_field.hpp"
#include "study/campaign/barrier_line.hpp"
#include "terrain/terrain_fit.hpp"

namespace clast {
namespace {

constexpr double kNarrowest = 0.45;  // height over width of the window, and the other way round

/// The box of what a map shows.
class MarkBox {
 public:
  void include(const Vec2& point) {
    if (!point.allFinite()) return;
    box_.low = box_.low.cwiseMin(point);
    box_.high = box_.high.cwiseMax(point);
  }
  /// Returns the window with a margin, neither too long nor too narrow.
  PlanWindow window() const {
    const double longer = std::max(box_.size().maxCoeff(), 4.0);
    const Vec2 middle = 0.5 * (box_.low + box_.high);
    Vec2 size = box_.size() + Vec2::Constant(0.14 * longer);
    size = size.cwiseMax(kNarrowest * size.maxCoeff());
    return {middle - 0.5 * size, middle + 0.5 * size};
  }

 private:
  PlanWindow box_{Vec2::Constant(INFINITY), Vec2::Constant(-INFINITY)};
};

/// Leaves the first release point of each location.
void drop_repeats(std::vector<ReleasePosition>& places) {
  std::set<std::pair<double, double>> known;
  std::vector<ReleasePosition> kept;
  for (const ReleasePosition& release : places) {
    if (known.emplace(release.position.x(), release.position.y()).second) kept.push_back(release);
  }
  places = std::move(kept);
}

/// Starts of one mass, in all realisations.
struct MassRelease {
  std::vector<Vec2> starts;
  std::set<std::uint32_t> realisations;
};

void add_release_traces(const Comparison& comparison, SiteMap& site) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, MassRelease> masses;
  for (const RunRow& row : comparison.rows) {
    const CampaignResults& results = comparison.results[row.file];
    if (results.persistent_blocks && results.persistent_blocks->at_once) {
      MassRelease& mass = masses[{row.file, row.record->point}];
      mass.starts.push_back(row.start.head<2>());
      mass.realisations.insert(cluster_index_of_run(results, *row.record));
    } else {
      site.release_positions.push_back({row.start.head<2>(), row.record->point});
    }
  }
  for (const auto& [mass, release] : masses) {
    std::vector<Vec2> corners = report_detail::plan_convex_hull(release.starts);
    if (corners.size() < 3) {
      for (const Vec2& start : release.starts)
        site.release_positions.push_back({start, mass.second});
      continue;
    }
    const std::size_t blocks = release.starts.size() / release.realisations.size();
    site.release_outlines.push_back(
        {"release of " + format_count(blocks, "block"), std::move(corners)});
  }
  drop_repeats(site.release_positions);
}

/// All of a terrain, with release points numbered in their order.
SiteMap whole_site(const Terrain& terrain, std::span<const Vec2> releases,
                   std::vector<BarrierLine> barriers) {
  SiteMap site;
  site.terrain = &terrain;
  site.barriers = std::move(barriers);
  MarkBox marks;
  for (std::uint32_t point = 0; point < releases.size(); ++point) {
    site.release_positions.push_back({releases[point], point});
    marks.include(releases[point]);
  }
  drop_repeats(site.release_positions);
  for (const BarrierLine& line : site.barriers) {
    for (const Vec2& point : line.vertices) marks.include(point);
  }
  const Bounds ground = bounds(terrain.surface);
  const Vec3 low = terrain.frame.to_map(ground.low), high = terrain.frame.to_map(ground.high);
  marks.include(low.head<2>());
  marks.include(high.head<2>());
  site.window = marks.window();
  site.lowest = low.z();
  site.highest = high.z();
  return site;
}

}  // namespace

double SiteMap::contour_interval() const {
  return std::max(0.1, round_up_to_nice_number((highest - lowest) / 12.0));
}

SiteMap make_site_map(const Comparison& comparison) {
  SiteMap site;
  site.terrain = &comparison.results.front().terrain;
  site.barriers = comparison.lines;
  MarkBox marks;
  for (const RunRow& row : comparison.rows) {
    marks.include(row.start.head<2>());
    if (row.record->result.stop_reason == StopReason::kError) continue;
    marks.include(row.stop.head<2>());
    site.lowest = std::min({site.lowest, row.start.z(), row.stop.z()});
    site.highest = std::max({site.highest, row.start.z(), row.stop.z()});
  }
  for (const BarrierLine& line : comparison.lines) {
    for (const Vec2& point : line.vertices) marks.include(point);
  }
  if (comparison.measured) {
    for (const MeasuredStop& stop : comparison.measured->stops) marks.include(stop.position);
  }
  site.window = marks.window();
  add_release_traces(comparison, site);
  return site;
}

SiteMap make_site_map(const CampaignHeader& header) {
  std::vector<Vec2> releases;
  for (const Vec3& point : header.release_points) {
    releases.push_back(header.frame.to_map(point).head<2>());
  }
  std::vector<BarrierLine> lines;
  for (const Barrier& barrier : header.barriers) {
    using Counts = BarrierLine::Counts;
    const Counts counts = is_ring(barrier.vertices)                       ? Counts::kEntries
                          : barrier.counted == CountedDirection::kForward ? Counts::kForward
                                                                          : Counts::kEither;
    lines.push_back({barrier.name, barrier.vertices, {0}, counts});
    for (Vec2& point : lines.back().vertices) point += header.frame.origin.head<2>();
  }
  return whole_site(header.terrain, releases, std::move(lines));
}

SiteMap make_site_map(const Terrain& terrain, std::span<const Vec2> releases,
                      const std::vector<std::vector<Vec2>>& lines) {
  check_positions_near_terrain(terrain, releases, "the release point");
  std::vector<BarrierLine> barriers;
  for (const std::vector<Vec2>& line : lines) {
    check_positions_near_terrain(terrain, line, "the barrier");
    barriers.push_back({.name = {}, .vertices = line, .files = {}});
  }
  SiteMap site = whole_site(terrain, releases, std::move(barriers));
  site.counts_crossings = false;
  return site;
}

}  // namespace clast

#include "report/maps/release_places.hpp"

#include <map>
#include <set>
#include <utility>

#include "core/number_text.hpp"
#include "report/charts/contour_field.hpp"

namespace clast::report_detail {
namespace {

/// Starts of one mass, in all realisations.
struct MassRelease {
  std::vector<Vec2> starts;
  std::set<std::uint32_t> realisations;
};

}  // namespace

ReleasePlaces release_places(const Comparison& comparison) {
  ReleasePlaces found;
  std::map<std::pair<std::uint32_t, std::uint32_t>, MassRelease> masses;
  std::set<std::pair<double, double>> known;
  const auto add_place = [&](const Vec2& place, std::uint32_t point) {
    if (known.emplace(place.x(), place.y()).second) found.places.push_back({place, point});
  };
  for (const RunRow& row : comparison.rows) {
    const CampaignResults& results = comparison.results[row.file];
    if (results.stay && results.stay->at_once) {
      MassRelease& mass = masses[{row.file, row.record->point}];
      mass.starts.push_back(row.start.head<2>());
      mass.realisations.insert(cluster_of(results, *row.record));
    } else {
      add_place(row.start.head<2>(), row.record->point);
    }
  }
  for (const auto& [mass, release] : masses) {
    std::vector<Vec2> corners = hull_of(release.starts);
    if (corners.size() < 3) {
      for (const Vec2& start : release.starts) add_place(start, mass.second);
      continue;
    }
    const std::size_t blocks = release.starts.size() / release.realisations.size();
    found.outlines.push_back({"release of " + counted(blocks, "block"), std::move(corners)});
  }
  return found;
}

}  // namespace clast::report_detail

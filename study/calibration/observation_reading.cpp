#include "study/calibration/observation_reading.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/detail/campaign_ranges.hpp"
#include "study/detail/campaign_reading.hpp"
#include "study/measured_stops.hpp"

namespace clast::study_detail {
namespace {

constexpr std::size_t kFewestStops = 3;
constexpr std::uint64_t kMostReleased = 1'000'000;

/// A figure of a barrier that is given as [value, standard error].
struct Quantity {
  const char* key;
  Figure::Kind kind;
  NumberRange range;
};
constexpr Quantity kQuantities[] = {
    {"speed_m_s", Figure::Kind::kMeanSpeed, {0.0, kMostSpeed, "m/s"}},
    {"spin_rad_s", Figure::Kind::kMeanSpin, {0.0, kMostSpin, "rad/s"}},
    {"height_m", Figure::Kind::kMeanHeight, {-1e4, 1e4, "m"}},
    {"energy_j", Figure::Kind::kMeanEnergy, {0.0, 1e15, "J"}}};

/// "mean", "std", "aside", or "p10" for a percentile.
Figure figure_named(const TomlTable& table, const TomlNode& node, const std::string& name) {
  if (name == "mean") return {Figure::Kind::kMeanPlace, 0.0, "mean_place_m", 0.0, {}};
  if (name == "std") return {Figure::Kind::kStdPlace, 0.0, "std_place_m", 0.0, {}};
  if (name == "aside") return {Figure::Kind::kMeanAside, 0.0, "mean_aside_m", 0.0, {}};
  const std::optional<double> level =
      name.starts_with("p") ? number_in(std::string_view(name).substr(1)) : std::nullopt;
  if (!level || !(*level >= 1.0 && *level <= 99.0)) {
    table.refuse("figures", node,
                 "must be \"mean\", \"std\", \"aside\", or a percentile from \"p1\" to \"p99\"");
  }
  return {Figure::Kind::kPlace, *level / 100.0, name + "_place_m", 0.0, {}};
}

std::vector<Figure> stop_figures(const TomlTable& table) {
  std::vector<Figure> figures;
  if (const TomlNode* asked = table.find("figures")) {
    const std::vector<std::string> names = *table.texts("figures");
    for (std::size_t i = 0; i < names.size(); ++i) {
      figures.push_back(figure_named(table, element(*asked, i), names[i]));
    }
  } else if (!table.find("beyond_m")) {
    figures = {{Figure::Kind::kMeanPlace, 0.0, "mean_place_m", 0.0, {}},
               {Figure::Kind::kStdPlace, 0.0, "std_place_m", 0.0, {}}};
  }
  if (const TomlNode* beyond = table.find("beyond_m")) {
    for (const double place : table.numbers("beyond_m", *beyond, 1, 20,
                                            "a list of places, [m, m, ...]", kMapCoordinate)) {
      figures.push_back(
          {Figure::Kind::kBeyond, place, "beyond_" + with_digits(place, 6) + "_m", 0.0, {}});
    }
  }
  return figures;
}

void check_once(const TomlTable& table, const std::vector<Figure>& figures) {
  for (std::size_t i = 0; i < figures.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (figures[i].name == figures[k].name) table.refuse("names " + figures[i].name + " twice");
    }
  }
}

bool is_of(const MeasuredStop& stop, const Observation& observation) {
  return (observation.shape.empty() || stop.shape == observation.shape) &&
         (observation.block.empty() || stop.block == observation.block);
}

/// Field releases that share a start, and whether all stops have one.
void read_starts(const std::vector<MeasuredStop>& stops, Observation& observation) {
  std::map<std::pair<double, double>, std::size_t> starts;
  for (const MeasuredStop& stop : stops) {
    if (!stop.start) return;
    ++starts[{stop.start->x(), stop.start->y()}];
  }
  observation.from_own_start = true;
  for (const auto& [start, count] : starts) observation.clusters.push_back(count);
}

void read_stops(const TomlTable& table, const SiteFacts& site, Observation& observation) {
  for (const char* key : {"releases", "passed"}) {
    if (const TomlNode* node = table.find(key)) {
      table.refuse(key, *node, "is of a barrier; a table of stops has its own number");
    }
  }
  for (const Quantity& quantity : kQuantities) {
    if (const TomlNode* node = table.find(quantity.key)) {
      table.refuse(quantity.key, *node, "is of a barrier; name it, or leave this out");
    }
  }
  const TomlNode& file = *table.find("stops");
  table.text("stops");
  const MeasuredStops measured = read_measured_stops(input_file(table, "stops", file));
  observation.table = measured.file;
  observation.sha256 = measured.sha256;
  observation.figures = stop_figures(table);
  check_once(table, observation.figures);
  std::vector<MeasuredStop> stops;
  for (const MeasuredStop& stop : measured.stops) {
    if (is_of(stop, observation)) stops.push_back(stop);
  }
  if (stops.size() < kFewestStops) {
    table.refuse("stops", file,
                 "has " + counted(stops.size(), "stop") + " of these blocks; " +
                     std::to_string(kFewestStops) + " are needed at least");
  }
  observation.releases = stops.size();
  read_starts(stops, observation);
  std::vector<ObservedStop> places;
  for (const MeasuredStop& stop : stops) {
    places.push_back(
        place_of(observation, site, stop.start.value_or(site.middle_of_starts), stop.place));
  }
  for (Figure& figure : observation.figures) {
    figure.observed = figure_of(figure, places);
  }
}

void read_passages(const TomlTable& table, const SiteFacts& site, Observation& observation) {
  for (const char* key : {"figures", "beyond_m"}) {
    if (const TomlNode* node = table.find(key)) {
      table.refuse(key, *node, "is of stops; name a table of them, or leave this out");
    }
  }
  observation.barrier = *table.text("barrier");
  if (std::find(site.barriers.begin(), site.barriers.end(), observation.barrier) ==
      site.barriers.end()) {
    table.refuse("barrier", *table.find("barrier"),
                 "the campaign of site " + site.name + " has no such barrier");
  }
  const std::optional<std::uint64_t> releases = table.count("releases", 1, kMostReleased);
  const std::optional<std::uint64_t> passed = table.count("passed", 0, kMostReleased);
  if (passed && !releases) {
    table.refuse("passed", *table.find("passed"), "needs releases, how many blocks were released");
  }
  if (passed && *passed > *releases) {
    table.refuse("passed", *table.find("passed"),
                 "is more than the " + std::to_string(*releases) + " releases");
  }
  observation.releases = releases.value_or(0);
  if (passed) {
    observation.figures.push_back({Figure::Kind::kPassed,
                                   0.0,
                                   "passed",
                                   static_cast<double>(*passed) / static_cast<double>(*releases),
                                   {}});
  }
  for (const Quantity& quantity : kQuantities) {
    const TomlNode* node = table.find(quantity.key);
    if (!node) continue;
    const std::vector<double> given = table.numbers(
        quantity.key, *node, 2, 2, "two numbers, [mean, its standard error]", quantity.range);
    if (!(given[1] > 0.0)) table.refuse(quantity.key, *node, "the error must be more than 0");
    observation.figures.push_back(
        {quantity.kind, 0.0, std::string("mean_") + quantity.key, given[0], given[1]});
  }
  if (observation.figures.empty()) {
    table.refuse(
        "names nothing that was observed: passed, speed_m_s, spin_rad_s, height_m or energy_j");
  }
}

std::size_t site_of(const TomlTable& table, const std::vector<CalibrationSite>& sites) {
  const std::optional<std::string> name = table.text("site");
  if (!name && sites.size() == 1) return 0;
  const TomlNode& node = table.required("site", "the name of a [[site]]");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (sites[i].name == *name) return i;
  }
  table.refuse("site", node, "there is no [[site]] of this name");
}

Observation read_observation(const TomlTable& table, const std::vector<CalibrationSite>& sites) {
  Observation observation;
  table.required("name", "a text in quotes");
  observation.name = *table.text("name");
  table.required("use", "\"fit\", or \"keep\" to judge the prediction by");
  observation.fitted = choice(table, "use", {"fit", "keep"}) == "fit";
  observation.site = site_of(table, sites);
  observation.shape = choice(table, "shape", {"compact", "elongated"}).value_or("");
  observation.block = table.text("block").value_or("");
  const SiteFacts site = path_of(sites[observation.site]);
  if (!table.find("stops") == !table.find("barrier")) {
    table.refuse("needs either stops, a table of them, or barrier, a name");
  }
  table.find("stops") ? read_stops(table, site, observation)
                      : read_passages(table, site, observation);
  return observation;
}

bool overlap(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() || a == b;
}

/// Are the same blocks behind both?
bool share_blocks(const Observation& a, const Observation& b) {
  return a.site == b.site && a.barrier == b.barrier && a.sha256 == b.sha256 &&
         overlap(a.shape, b.shape) && overlap(a.block, b.block);
}

}  // namespace

SiteFacts path_of(const CalibrationSite& site) {
  SiteFacts facts;
  facts.name = site.name;
  for (const Barrier& barrier : site.campaign.barriers) facts.barriers.push_back(barrier.name);
  facts.downslope = site.campaign.downslope.value_or(Vec2::UnitX()).normalized();
  // Summed from the first: map coordinates of 5e6 m would cost digits.
  const Vec2 first = site.campaign.releases.front().points.front().head<2>();
  Vec2 sum = Vec2::Zero();
  std::size_t count = 0;
  for (const ReleasePlan& release : site.campaign.releases) {
    for (const Vec3& point : release.points) {
      sum += point.head<2>() - first;
      ++count;
    }
  }
  facts.middle_of_starts = first + sum / static_cast<double>(count);
  return facts;
}

std::vector<Observation> read_observations(const TomlTable& top,
                                           const std::vector<CalibrationSite>& sites) {
  std::vector<Observation> observations;
  for (const TomlNode* node : tables_of(top, "observation")) {
    const TomlTable table(
        *node, top.file(), "[[observation]]",
        {"name", "site", "use", "shape", "block", "stops", "figures", "beyond_m", "barrier",
         "releases", "passed", "speed_m_s", "spin_rad_s", "height_m", "energy_j"});
    Observation observation = read_observation(table, sites);
    for (const Observation& other : observations) {
      if (other.name == observation.name) {
        table.refuse("name", *table.find("name"), "another observation has this name");
      }
      if (other.fitted != observation.fitted && share_blocks(other, observation)) {
        table.refuse("use", *table.find("use"),
                     "observation " + other.name +
                         " is of the same blocks; what is fitted can't be kept to judge by");
      }
    }
    observations.push_back(std::move(observation));
  }
  if (std::none_of(observations.begin(), observations.end(),
                   [](const Observation& observation) { return observation.fitted; })) {
    throw InputError(top.file() +
                     ": nothing is fitted: write a table [[observation]] with use = \"fit\"");
  }
  return observations;
}

}  // namespace clast::study_detail

#include "study/calibrate/observation_reading.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/calibrate/observed_trajectories.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/compare/measured_stops.hpp"

namespace clast::study_detail {
namespace {

constexpr std::size_t kMinStops = 3;

/// A figure of a barrier or an impact that is given as [value, standard error].
struct MeasuredQuantity {
  const char* key;
  SummaryStatistic::Kind kind;
};
constexpr MeasuredQuantity kQuantities[] = {
    {"speed_m_s", SummaryStatistic::Kind::kMeanSpeed},
    {"spin_rad_s", SummaryStatistic::Kind::kMeanAngularSpeed},
    {"height_m", SummaryStatistic::Kind::kMeanHeight},
    {"energy_j", SummaryStatistic::Kind::kMeanEnergy},
    {"depth_m", SummaryStatistic::Kind::kMeanScarDepth}};

bool is_fitted(const std::string& use) { return use == "fit"; }

/// Reads the numbers of a required list.
std::vector<double> numbers_of(const DeclaredTable& table, const std::string& key,
                               const std::string& expected) {
  const ValueFormat& form = table.value_format(key);
  return table.read_numbers(key, table.require_key(key, expected), form.minimum, form.maximum,
                            expected, form.innermost_format().range);
}

/// Returns the one of the mutually exclusive keys that is given.
/// @throws InputError  if none or several are given, or a key that does not apply to it
std::string source_of(const DeclaredTable& table) {
  std::string source;
  for (const std::string& one : observation_keys().exactly_one_of) {
    if (!table.find(one)) continue;
    if (!source.empty()) {
      table.refuse("has " + source + " and " + one + "; write two observations");
    }
    source = one;
  }
  if (source.empty()) {
    table.refuse(
        "needs one of stops (a file), trajectories (a file), barrier (a name) or impact (a "
        "number)");
  }
  for (const TableKey& key : observation_keys().keys) {
    const TomlNode* node = table.find(key.name);
    if (!node || key.required_with.empty() ||
        std::find(key.required_with.begin(), key.required_with.end(), source) !=
            key.required_with.end()) {
      continue;
    }
    table.refuse(key.name, *node,
                 "applies only to an observation with " + comma_separated(key.required_with) +
                     "; leave it out here");
  }
  return source;
}

/// Parses the name of a statistic: "mean", "std", "aside", or "p10" for a percentile.
SummaryStatistic figure_named(const TomlTable& table, const TomlNode& node,
                              const std::string& name) {
  if (name == "mean")
    return {SummaryStatistic::Kind::kMeanStopPosition, 0.0, "mean_place_m", 0.0, {}};
  if (name == "std") return {SummaryStatistic::Kind::kStopDeviation, 0.0, "std_place_m", 0.0, {}};
  if (name == "aside")
    return {SummaryStatistic::Kind::kMeanLateralPosition, 0.0, "mean_aside_m", 0.0, {}};
  const std::optional<double> level =
      name.starts_with("p") ? parse_number(std::string_view(name).substr(1)) : std::nullopt;
  if (!level || !(*level >= 1.0 && *level <= 99.0)) {
    table.refuse("figures", node,
                 "must be \"mean\", \"std\", \"aside\", or a percentile from \"p1\" to \"p99\"");
  }
  return {SummaryStatistic::Kind::kStopQuantile, *level / 100.0, name + "_place_m", 0.0, {}};
}

std::vector<SummaryStatistic> stop_figures(const DeclaredTable& table) {
  std::vector<SummaryStatistic> statistics;
  if (const TomlNode* asked = table.find("figures")) {
    const std::vector<std::string> names = *table.read_text_list("figures");
    for (std::size_t i = 0; i < names.size(); ++i) {
      statistics.push_back(figure_named(table, element(*asked, i), names[i]));
    }
  } else if (!table.find("beyond_m")) {
    statistics = {{SummaryStatistic::Kind::kMeanStopPosition, 0.0, "mean_place_m", 0.0, {}},
                  {SummaryStatistic::Kind::kStopDeviation, 0.0, "std_place_m", 0.0, {}}};
  }
  if (table.find("beyond_m")) {
    for (const double place : numbers_of(table, "beyond_m", "a list of distances, [m, m, ...]")) {
      statistics.push_back({SummaryStatistic::Kind::kFractionBeyond,
                            place,
                            "beyond_" + format_significant(place, 6) + "_m",
                            0.0,
                            {}});
    }
  }
  return statistics;
}

void check_once(const DeclaredTable& table, const std::vector<SummaryStatistic>& statistics) {
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (statistics[i].name == statistics[k].name)
        table.refuse("names " + statistics[i].name + " twice");
    }
  }
}

bool is_of(const MeasuredStop& stop, const Observation& observation) {
  return (observation.shape.empty() || stop.shape == observation.shape) &&
         (observation.block.empty() || stop.block == observation.block);
}

/// Counts the field releases of each start, and notes whether all stops have a start.
void read_starts(const std::vector<MeasuredStop>& stops, Observation& observation) {
  std::map<std::pair<double, double>, std::size_t> starts;
  for (const MeasuredStop& stop : stops) {
    if (!stop.start) return;
    ++starts[{stop.start->x(), stop.start->y()}];
  }
  observation.measured_from_own_start = true;
  for (const auto& [start, count] : starts) observation.clusters.push_back(count);
}

void read_stops(const DeclaredTable& table, const SiteDescription& site, Observation& observation) {
  const TomlNode& file = *table.find("stops");
  const MeasuredStops measured = read_measured_stops(*table.value<std::filesystem::path>("stops"));
  observation.table = measured.file;
  observation.sha256 = measured.sha256;
  observation.statistics = stop_figures(table);
  check_once(table, observation.statistics);
  std::vector<MeasuredStop> stops;
  for (const MeasuredStop& stop : measured.stops) {
    if (is_of(stop, observation)) stops.push_back(stop);
  }
  if (stops.size() < kMinStops) {
    table.refuse("stops", file,
                 "has " + format_count(stops.size(), "stop") + " of these blocks; " +
                     std::to_string(kMinStops) + " are needed at least");
  }
  observation.releases = stops.size();
  read_starts(stops, observation);
  std::vector<StopPosition> places;
  for (const MeasuredStop& stop : stops) {
    places.push_back(
        stop_position_of(observation, site, stop.start.value_or(site.mean_start), stop.position));
  }
  for (SummaryStatistic& statistic : observation.statistics) {
    statistic.observed = compute_statistic(statistic, places);
  }
}

/// Quantities that are given as [value, standard error].
std::vector<SummaryStatistic> stated_figures(const DeclaredTable& table) {
  std::vector<SummaryStatistic> statistics;
  for (const MeasuredQuantity& quantity : kQuantities) {
    const TomlNode* node = table.find(quantity.key);
    if (!node) continue;
    const std::vector<double> given =
        numbers_of(table, quantity.key, "two numbers, [mean, its standard error]");
    if (!(given[1] > 0.0)) table.refuse(quantity.key, *node, "the error must be more than 0");
    statistics.push_back(
        {quantity.kind, 0.0, std::string("mean_") + quantity.key, given[0], given[1]});
  }
  return statistics;
}

/// Reads one impact, or the mean of several. The states before impact are those of the campaign, so
/// the scatter of as many simulated impacts is added to the measurement error.
void read_impact(const DeclaredTable& table, Observation& observation) {
  observation.moment = {ObservedMoment::Kind::kImpact,
                        static_cast<double>(*table.value<std::uint64_t>("impact"))};
  observation.releases = table.value<std::uint64_t>("releases").value_or(1);
  observation.statistics = stated_figures(table);
  for (SummaryStatistic& statistic : observation.statistics)
    statistic.measurement_error = *std::exchange(statistic.error, {});
  if (observation.statistics.empty()) {
    table.refuse("has no observed value: add speed_m_s, spin_rad_s, energy_j or depth_m");
  }
}

/// Returns the statistics of trajectories at each time: positions along the path, speed and spin.
std::vector<SummaryStatistic> trajectory_figures(const DeclaredTable& table) {
  std::vector<SummaryStatistic> statistics;
  const auto add = [&](const std::string& name, const auto& place) {
    if (name == "speed") {
      statistics.push_back({SummaryStatistic::Kind::kMeanSpeed, 0.0, "mean_speed_m_s", 0.0, {}});
    } else if (name == "spin") {
      statistics.push_back(
          {SummaryStatistic::Kind::kMeanAngularSpeed, 0.0, "mean_spin_rad_s", 0.0, {}});
    } else {
      statistics.push_back(place());
    }
  };
  if (const TomlNode* asked = table.find("figures")) {
    const std::vector<std::string> names = *table.read_text_list("figures");
    for (std::size_t i = 0; i < names.size(); ++i) {
      add(names[i], [&] { return figure_named(table, element(*asked, i), names[i]); });
    }
  } else {
    add("mean", [] {
      return SummaryStatistic{
          SummaryStatistic::Kind::kMeanStopPosition, 0.0, "mean_place_m", 0.0, {}};
    });
    add("speed", [] { return SummaryStatistic(); });
    add("spin", [] { return SummaryStatistic(); });
  }
  return statistics;
}

/// One observation at each of the times.
std::vector<Observation> read_followed(const DeclaredTable& table, const SiteDescription& site,
                                       Observation common) {
  const TomlNode& file = *table.find("trajectories");
  common.table = *table.value<std::filesystem::path>("trajectories");
  const ObservedTrajectorySet followed = read_trajectories(common.table);
  common.sha256 = followed.sha256;
  common.releases = followed.all.size();
  if (common.releases < kMinStops) {
    table.refuse("trajectories", file,
                 "has " + std::to_string(common.releases) + " trajectories; " +
                     std::to_string(kMinStops) + " are needed at least");
  }
  std::vector<MeasuredStop> starts;
  for (const ObservedTrajectory& one : followed.all) {
    starts.push_back({one.front().position, one.front().position, {}, {}, 0.0, 0.0});
  }
  read_starts(starts, common);
  common.statistics = trajectory_figures(table);
  check_once(table, common.statistics);
  table.require_key("times_s", "a list of times since the release");
  std::vector<Observation> observations;
  for (const double time :
       numbers_of(table, "times_s", "a list of times since the release, [s, s, ...]")) {
    if (time > followed.longest()) {
      table.refuse("times_s", "the longest trajectory ends before " + format_significant(time, 6));
    }
    Observation own = common;
    own.moment = {ObservedMoment::Kind::kTime, time};
    own.name += " at " + own.moment->name();
    std::vector<SelectedOutcome> seen;
    std::vector<std::size_t> all;
    for (const ObservedTrajectory& one : followed.all) {
      const TrajectoryPoint point = interpolate_trajectory(one, time);
      const StopPosition place = stop_position_of(own, site, one.front().position, point.position);
      OutcomeAtMoment at;
      at.speed = point.speed;
      at.spin = point.spin;
      all.push_back(seen.size());
      seen.push_back({0, place.along, place.lateral, at});
    }
    for (SummaryStatistic& statistic : own.statistics)
      statistic.observed = compute_statistic(statistic, seen, all);
    observations.push_back(std::move(own));
  }
  return observations;
}

void read_passages(const DeclaredTable& table, const SiteDescription& site,
                   Observation& observation) {
  observation.barrier = *table.read_text("barrier");
  if (std::find(site.barriers.begin(), site.barriers.end(), observation.barrier) ==
      site.barriers.end()) {
    table.refuse("barrier", "the campaign of site " + site.name + " has no such barrier");
  }
  const std::optional<std::uint64_t> releases = table.value<std::uint64_t>("releases");
  const std::optional<std::uint64_t> passed = table.value<std::uint64_t>("passed");
  if (passed && !releases) {
    table.refuse("passed", "needs releases, the number of released blocks");
  }
  if (passed && *passed > *releases) {
    table.refuse("passed", "exceeds the " + std::to_string(*releases) + " releases");
  }
  observation.releases = releases.value_or(0);
  if (passed) {
    observation.statistics.push_back({SummaryStatistic::Kind::kPassedFraction,
                                      0.0,
                                      "passed",
                                      static_cast<double>(*passed) / static_cast<double>(*releases),
                                      {}});
  }
  const std::vector<SummaryStatistic> stated = stated_figures(table);
  observation.statistics.insert(observation.statistics.end(), stated.begin(), stated.end());
  if (observation.statistics.empty()) {
    table.refuse("has no observed value: add passed, speed_m_s, spin_rad_s, height_m or energy_j");
  }
}

std::size_t site_of(const DeclaredTable& table, const std::vector<CalibrationSite>& sites) {
  const std::optional<std::string> name = table.read_text("site");
  if (!name && sites.size() == 1) return 0;
  const TomlNode& node = table.require_key("site", "the name of a [[site]]");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (sites[i].name == *name) return i;
  }
  table.refuse("site", node, "there is no [[site]] of this name");
}

void check_release(const DeclaredTable& table, const SiteDescription& site,
                   const std::string& release) {
  if (release.empty() ||
      std::find(site.releases.begin(), site.releases.end(), release) != site.releases.end()) {
    return;
  }
  table.refuse("release", "the campaign of site " + site.name + " has no [[release]] of this name");
}

std::vector<Observation> read_observation(const DeclaredTable& table,
                                          const std::vector<CalibrationSite>& sites) {
  Observation observation;
  observation_keys().read(table, observation);
  observation.site = site_of(table, sites);
  const SiteDescription site = read_site_path(sites[observation.site]);
  check_release(table, site, observation.release);
  const std::string source = source_of(table);
  if (source == "trajectories") return read_followed(table, site, std::move(observation));
  if (source == "stops") read_stops(table, site, observation);
  if (source == "barrier") read_passages(table, site, observation);
  if (source == "impact") read_impact(table, observation);
  return {observation};
}

bool overlap(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() || a == b;
}

/// Returns the number of the impact; 0 if the observation is not of an impact.
double impact_of(const Observation& observation) {
  const std::optional<ObservedMoment>& moment = observation.moment;
  return moment && moment->kind == ObservedMoment::Kind::kImpact ? moment->value : 0.0;
}

/// True if both observations have the same blocks.
bool share_blocks(const Observation& a, const Observation& b) {
  return a.site == b.site && a.barrier == b.barrier && a.sha256 == b.sha256 &&
         impact_of(a) == impact_of(b) && overlap(a.shape, b.shape) && overlap(a.block, b.block) &&
         overlap(a.release, b.release);
}

}  // namespace

const MemberTable<Observation>& observation_keys() {
  const auto measured = [](const NumberRange& range) {
    return list_format(number_format(range), 2, 2);
  };
  const ValueFormat statistic = pattern_format("^(mean|std|aside|speed|spin|p[0-9.+].*)$");
  using Names = std::vector<std::string>;
  const Names stops = {"stops"}, places = {"stops", "trajectories"}, barrier = {"barrier"},
              moving = {"barrier", "impact"}, impact = {"impact"}, followed = {"trajectories"};
  static const MemberTable<Observation> keys(
      {"observation",
       "Observations of blocks at a site",
       KeyTable::Repeat::kEither,
       {},
       true,
       {"stops", "barrier", "impact", "trajectories"}},
      {{"name", "", "name of the observation", required_format("a text in quotes", text_format()),
        &Observation::name},
       {"site", "", "name of the site, required if there are several", text_format()},
       {"use", "", "fitted, or kept for validation",
        required_format("\"fit\", or \"keep\" for validation", word_format({"fit", "keep"})),
        &is_fitted, &Observation::fitted},
       {"shape", "", "only blocks of this shape", word_format({"compact", "elongated"}),
        &Observation::shape},
       {"block", "", "only the block with this id", text_format(), &Observation::block},
       {"stops", "", "file with a table of stops", text_format()},
       TableKey{"figures", "",
                "statistics of the stops: mean, std, aside, p1 to p99; of trajectories also speed "
                "and spin",
                one_or_more_format(statistic), places},
       TableKey{"beyond_m", "m",
                "distances along downslope: the fraction of stops beyond each is used",
                list_format(number_format(kMapCoordinateRange), 1, 20), stops},
       {"barrier", "", "name of a barrier of the campaign", text_format()},
       TableKey{"releases", "",
                "number of released blocks, or of the impacts over which the values are averaged",
                count_format(1, kMaxItemsPerSet), moving},
       TableKey{"passed", "", "number of released blocks that passed",
                count_format(0, kMaxItemsPerSet), barrier},
       TableKey{"speed_m_s", "m/s", "mean speed, [value, standard error]",
                measured({0.0, kMaxInitialSpeed, "m/s"}), moving},
       TableKey{"spin_rad_s", "rad/s", "mean spin, [value, standard error]",
                measured({0.0, kMaxInitialSpin, "rad/s"}), moving},
       TableKey{"height_m", "m",
                "mean height of the centre above the ground, [value, standard error]",
                measured({-1e4, 1e4, "m"}), barrier},
       TableKey{"energy_j", "J",
                "mean translational plus rotational energy, [value, standard error]",
                measured({0.0, 1e15, "J"}), moving},
       {"release", "", "only runs of the [[release]] of this name", text_format(),
        &Observation::release},
       {"impact", "", "number of an impact of each run, from 1", count_format(1, 1000)},
       TableKey{"depth_m", "m", "mean depth of the impact scar, [value, standard error]",
                measured({0.0, 1e3, "m"}), impact},
       {"trajectories", "", "file with a table of trajectories", text_format()},
       TableKey{"times_s", "s", "times since the release at which trajectories are compared",
                list_format(number_format(kRunTimeRange), 1, 100), followed}});
  return keys;
}

SiteDescription read_site_path(const CalibrationSite& site) {
  SiteDescription facts;
  facts.name = site.name;
  for (const Barrier& barrier : site.campaign.barriers) facts.barriers.push_back(barrier.name);
  for (const ReleaseSet& release : site.campaign.releases) facts.releases.push_back(release.name);
  facts.downslope = site.campaign.downslope.value_or(Vec2::UnitX()).normalized();
  // Summed from the first: map coordinates of 5e6 m would cost digits.
  const Vec2 first = site.campaign.releases.front().points.front().head<2>();
  Vec2 sum = Vec2::Zero();
  std::size_t count = 0;
  for (const ReleaseSet& release : site.campaign.releases) {
    for (const Vec3& point : release.points) {
      sum += point.head<2>() - first;
      ++count;
    }
  }
  facts.mean_start = first + sum / static_cast<double>(count);
  return facts;
}

std::vector<Observation> read_observations(const TomlTable& top,
                                           const std::vector<CalibrationSite>& sites) {
  std::vector<Observation> observations;
  for (const DeclaredTable& table : find_tables(top, observation_keys())) {
    for (Observation& observation : read_observation(table, sites)) {
      check_unique_name(table, observation.name, observations, "observation");
      for (const Observation& other : observations) {
        if (other.fitted != observation.fitted && share_blocks(other, observation)) {
          table.refuse("use", "observation " + other.name +
                                  " uses the same blocks; observations of fitted blocks cannot be "
                                  "kept for validation");
        }
      }
      observations.push_back(std::move(observation));
    }
  }
  if (std::none_of(observations.begin(), observations.end(),
                   [](const Observation& observation) { return observation.fitted; })) {
    throw InputError(top.file() +
                     ": nothing is fitted: write a table [[observation]] with use = \"fit\"");
  }
  return observations;
}

}  // namespace clast::study_detail

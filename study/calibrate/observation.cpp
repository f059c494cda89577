#include "study/calibrate/observation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/statistics/statistics.hpp"

namespace clast {
namespace {

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

void check_known(const Observation& observation, const SiteDescription& site,
                 const std::string& what, const std::string& wanted,
                 const std::vector<std::string>& known) {
  if (wanted.empty() || std::find(known.begin(), known.end(), wanted) != known.end()) return;
  std::vector<std::string> once = known;
  std::sort(once.begin(), once.end());
  once.erase(std::unique(once.begin(), once.end()), once.end());
  throw InputError("observation " + observation.name + ": the campaign of site " + site.name +
                   " has no " + what + " \"" + wanted + "\"; it has " +
                   (once.empty() ? "none" : comma_separated(once)));
}

std::size_t place_of_moment(const Observation& observation, const SiteDescription& site) {
  if (!observation.moment) return 0;
  const auto moment = std::find(site.moments.begin(), site.moments.end(), *observation.moment);
  if (moment == site.moments.end()) {
    throw InputError("observation " + observation.name + ": site " + site.name +
                     " was simulated without " + observation.moment->name() +
                     "; simulate its members again");
  }
  return static_cast<std::size_t>(moment - site.moments.begin());
}

double mean_of_values(const std::vector<double>& values) {
  if (values.empty()) return kNoFigure;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Sample standard deviation, with n - 1.
double deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return kNoFigure;
  const double mean = mean_of_values(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double figure_of_places(const SummaryStatistic& statistic, std::vector<double> along,
                        const std::vector<double>& lateral) {
  if (along.empty()) return kNoFigure;
  switch (statistic.kind) {
    case SummaryStatistic::Kind::kMeanStopPosition:
      return mean_of_values(along);
    case SummaryStatistic::Kind::kStopDeviation:
      return deviation_of(along);
    case SummaryStatistic::Kind::kStopQuantile:
      std::sort(along.begin(), along.end());
      return quantile(along, statistic.level);
    case SummaryStatistic::Kind::kFractionBeyond: {
      const auto beyond = std::count_if(along.begin(), along.end(),
                                        [&](double place) { return place > statistic.level; });
      return static_cast<double>(beyond) / static_cast<double>(along.size());
    }
    case SummaryStatistic::Kind::kMeanLateralPosition:
      return mean_of_values(lateral);
    default:
      return kNoFigure;
  }
}

/// Returns the quantity measured at barriers and moments; null for other statistics.
double OutcomeAtMoment::*measured_member(SummaryStatistic::Kind kind) {
  switch (kind) {
    case SummaryStatistic::Kind::kMeanSpeed:
      return &OutcomeAtMoment::speed;
    case SummaryStatistic::Kind::kMeanAngularSpeed:
      return &OutcomeAtMoment::spin;
    case SummaryStatistic::Kind::kMeanHeight:
      return &OutcomeAtMoment::height;
    case SummaryStatistic::Kind::kMeanEnergy:
      return &OutcomeAtMoment::energy;
    case SummaryStatistic::Kind::kMeanScarDepth:
      return &OutcomeAtMoment::depth;
    default:
      return nullptr;
  }
}

}  // namespace

std::string ObservedMoment::name() const {
  return kind == Kind::kImpact ? "impact " + format_significant(value, 6)
                               : format_significant(value, 6) + " s";
}

std::vector<ObservedMoment> observed_moments(const std::vector<Observation>& observations,
                                             std::size_t site) {
  std::set<ObservedMoment> moments;
  for (const Observation& observation : observations) {
    if (observation.site == site && observation.moment) moments.insert(*observation.moment);
  }
  return {moments.begin(), moments.end()};
}

StopPosition stop_position_of(const Observation& observation, const SiteDescription& site,
                              const Vec2& start, const Vec2& stop) {
  const Vec2 offset = stop - (observation.measured_from_own_start ? start : site.mean_start);
  const Vec2 right(site.downslope.y(), -site.downslope.x());
  return {offset.dot(site.downslope), offset.dot(right)};
}

std::vector<SelectedOutcome> select_outcomes(const Observation& observation,
                                             const SiteDescription& site,
                                             std::span<const ReleaseOutcome> outcomes) {
  check_known(observation, site, "block", observation.block, site.blocks);
  check_known(observation, site, "block of shape", observation.shape, site.shapes);
  check_known(observation, site, "barrier", observation.barrier, site.barriers);
  check_known(observation, site, "release set", observation.release, site.releases);
  const auto barrier = static_cast<std::size_t>(
      std::find(site.barriers.begin(), site.barriers.end(), observation.barrier) -
      site.barriers.begin());
  const std::size_t moment = place_of_moment(observation, site);
  std::vector<SelectedOutcome> seen;
  for (const ReleaseOutcome& outcome : outcomes) {
    if (!observation.block.empty() && site.blocks[outcome.block] != observation.block) continue;
    if (!observation.shape.empty() && site.shapes[outcome.block] != observation.shape) continue;
    if (!observation.release.empty() && site.releases[outcome.release] != observation.release) {
      continue;
    }
    OutcomeAtMoment at;
    if (observation.moment) at = outcome.moments[moment];
    if (!observation.barrier.empty()) at = outcome.barriers[barrier];
    const StopPosition place = stop_position_of(observation, site, outcome.start,
                                                observation.moment ? at.position : outcome.stop);
    seen.push_back({outcome.point, place.along, place.lateral, at});
  }
  return seen;
}

void check_outcome_count(const Observation& observation, std::span<const SelectedOutcome> seen) {
  if (seen.size() >= kMinSelectedOutcomes) return;
  throw InputError("observation " + observation.name + ": a member has only " +
                   std::to_string(seen.size()) + " releases of these blocks, but " +
                   std::to_string(kMinSelectedOutcomes) + " are needed; raise [design] releases");
}

double compute_statistic(const SummaryStatistic& statistic, std::span<const SelectedOutcome> seen,
                         std::span<const std::size_t> sample) {
  std::vector<double> values, lateral;
  if (statistic.kind == SummaryStatistic::Kind::kPassedFraction) {
    for (const std::size_t i : sample) values.push_back(seen[i].at.passed() ? 1.0 : 0.0);
    return mean_of_values(values);
  }
  if (double OutcomeAtMoment::*const quantity = measured_member(statistic.kind)) {
    for (const std::size_t i : sample) {
      if (seen[i].at.passed()) values.push_back(seen[i].at.*quantity);
    }
    return mean_of_values(values);
  }
  for (const std::size_t i : sample) {
    values.push_back(seen[i].along);
    lateral.push_back(seen[i].lateral);
  }
  return figure_of_places(statistic, std::move(values), lateral);
}

double compute_statistic(const SummaryStatistic& statistic, std::span<const StopPosition> stops) {
  std::vector<double> along, lateral;
  for (const StopPosition& stop : stops) {
    along.push_back(stop.along);
    lateral.push_back(stop.lateral);
  }
  return figure_of_places(statistic, std::move(along), lateral);
}

}  // namespace clast

#pragma once
/// Sites whose blocks obey formulas, so that calibrations are tested on a known truth in no time.
#include <cmath>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/posterior.hpp"

namespace clast {

/// Blocks slide and roll down from release points of their own heights. Where they stop and how
/// fast they pass depends on two unknowns, friction and rolling friction; a third has no influence.
struct MadeUpSite {
  double reach = 1.0;      ///< the slope's own length scale
  double bend = 0.0;       ///< of the law: what no value of the unknowns makes up for
  std::uint64_t seed = 1;  ///< of the release points
  std::size_t points = 8;
  static constexpr double kPointSpread = 2.0, kRunSpread = 5.0;  ///< of stops, m

  double point_effect(std::size_t point) const {
    Random random(seed * 1000 + point);
    return kPointSpread * random.normal();
  }

  /// One release; shape 0 is compact, 1 elongated.
  ReleaseOutcome release(const std::vector<double>& values, std::uint32_t shape,
                         std::uint32_t point, double effect, Random& random) const {
    const double mu = values[0], rolling = values[1];
    const double rolls = shape == 0 ? 60.0 : 25.0, slides = shape == 0 ? 30.0 : 55.0;
    const double mean =
        reach * (75.0 - slides * mu - rolls * rolling) + (shape == 0 ? bend : -bend);
    ReleaseOutcome outcome;
    outcome.block = shape;
    outcome.point = point;
    outcome.stop = {mean + effect + kRunSpread * random.normal(), 2.0 * random.normal()};
    OutcomeAtMoment passage;
    const double speed = 12.0 - 5.0 * mu - 2.0 * rolling + 1.5 * random.normal();
    const double spin = 9.0 - 12.0 * rolling - 2.0 * mu + 1.2 * random.normal();
    const double height = 1.0 + 0.2 * random.normal();
    if (outcome.stop.x() > 20.0) passage = {speed, spin, height, 350.0 * speed * speed};
    outcome.barriers = {passage};
    return outcome;
  }

  SiteDescription description(const std::string& name) const {
    return {name, {"A", "B"}, {"compact", "elongated"}, {"EC"}, Vec2::UnitX(), Vec2::Zero()};
  }

  std::vector<ReleaseOutcome> member(const std::vector<double>& values, std::uint32_t releases,
                                     std::uint64_t member_seed) const {
    Random random(member_seed);
    std::vector<ReleaseOutcome> outcomes;
    for (std::uint32_t i = 0; i < releases; ++i) {
      const auto point = static_cast<std::uint32_t>((i / 2) % points);
      outcomes.push_back(release(values, i % 2, point, point_effect(point), random));
    }
    return outcomes;
  }
};

/// Throws of known speed, and what one impact makes of them; how a block hits is not known.
struct MadeUpThrows {
  static constexpr std::uint32_t kThrows = 6;
  static constexpr double kMeasuringError = 0.2;  ///< of speeds, m/s, and spins, rad/s
  double bend = 0.0;                              ///< of the law, m/s: what no unknown makes up for

  ReleaseOutcome thrown(const std::vector<double>& values, std::uint32_t number,
                        Random& random) const {
    const double incoming = 5.0 + number;
    OutcomeAtMoment after;
    after.speed = incoming * (0.9 - 0.6 * values[0]) + 0.5 * random.normal() +
                  (number % 2 == 0 ? bend : -bend);
    after.spin = incoming * (1.2 - 0.3 * values[0] - 1.5 * values[1]) + 0.6 * random.normal();
    after.depth = 0.01 * incoming * (1.5 - 4.0 * values[2]) + 0.01 * random.normal();
    ReleaseOutcome outcome;
    outcome.point = outcome.release = number;
    outcome.moments = {after};
    return outcome;
  }

  static std::string name(std::uint32_t number) { return "throw " + std::to_string(number); }
  static SiteDescription description() {
    SiteDescription facts{"throws", {"A"}, {"compact"}, {}, Vec2::UnitX(), Vec2::Zero()};
    for (std::uint32_t i = 0; i < kThrows; ++i) facts.releases.push_back(name(i));
    facts.moments = {{ObservedMoment::Kind::kImpact, 1.0}};
    return facts;
  }

  std::vector<ReleaseOutcome> member(const std::vector<double>& values, std::uint32_t releases,
                                     std::uint64_t member_seed) const {
    Random random(member_seed);
    std::vector<ReleaseOutcome> outcomes;
    for (std::uint32_t i = 0; i < releases; ++i) {
      outcomes.push_back(thrown(values, i % kThrows, random));
    }
    return outcomes;
  }
};

/// Field releases of a shape, each from a place of its own.
inline std::vector<ReleaseOutcome> field_releases(const MadeUpSite& site,
                                                  const std::vector<double>& truth,
                                                  std::uint32_t shape, std::size_t count,
                                                  Random& random) {
  std::vector<ReleaseOutcome> outcomes;
  for (std::size_t i = 0; i < count; ++i) {
    const double effect = MadeUpSite::kPointSpread * random.normal();
    outcomes.push_back(site.release(truth, shape, 0, effect, random));
  }
  return outcomes;
}

/// A study of made-up sites, its runs, and observations made of a truth.
struct MadeUpStudy {
  CalibrationStudy study;
  CalibrationRuns runs;

  MadeUpStudy(std::uint32_t members, std::uint32_t releases, std::uint64_t seed) {
    study.file = "study.toml";
    study.unknowns = {{"ground.scree.friction", 0.3, 0.9, false},
                      {"ground.scree.rolling_friction", 0.05, 0.5, true},
                      {"ground.scree.energy_restitution", 0.01, 0.2, false}};
    study.design = {members, releases, seed, 1000, Kernel::kMatern52};
  }

  /// @returns the number of the site
  std::size_t add_site(const std::string& name, const MadeUpSite& site) {
    study.sites.push_back({name, {}});
    runs.sites.push_back(site.description(name));
    runs.outcomes.emplace_back();
    std::uint64_t member = 0;
    for (const std::vector<double>& place : study.design.sobol_points(study.unknowns.size())) {
      runs.outcomes.back().push_back(site.member(study.values(place),
                                                 study.design.releases_per_member,
                                                 97 * study.design.seed + 13 * ++member));
    }
    return runs.sites.size() - 1;
  }

  /// @returns the number of the site
  std::size_t add_throws() {
    study.sites.push_back({"throws", {}});
    runs.sites.push_back(MadeUpThrows::description());
    runs.outcomes.emplace_back();
    std::uint64_t member = 0;
    for (const std::vector<double>& place : study.design.sobol_points(study.unknowns.size())) {
      runs.outcomes.back().push_back(MadeUpThrows().member(study.values(place),
                                                           study.design.releases_per_member,
                                                           89 * study.design.seed + 17 * ++member));
    }
    return runs.sites.size() - 1;
  }

  /// Speed, spin and scar of one impact of each throw, with errors of measuring.
  void observe_throws(std::size_t number, const MadeUpThrows& field,
                      const std::vector<double>& truth, std::uint64_t seed) {
    Random random(seed);
    for (std::uint32_t i = 0; i < MadeUpThrows::kThrows; ++i) {
      const OutcomeAtMoment after = field.thrown(truth, i, random).moments.front();
      Observation impact;
      impact.name = MadeUpThrows::name(i);
      impact.site = number;
      impact.release = impact.name;
      impact.releases = 1;
      impact.moment = {ObservedMoment::Kind::kImpact, 1.0};
      const auto measured = [&](SummaryStatistic::Kind kind, const char* name, double value,
                                double error) {
        SummaryStatistic statistic{kind, 0.0, name, value + error * random.normal(), {}};
        statistic.measurement_error = error;
        impact.statistics.push_back(statistic);
      };
      measured(SummaryStatistic::Kind::kMeanSpeed, "mean_speed_m_s", after.speed,
               MadeUpThrows::kMeasuringError);
      measured(SummaryStatistic::Kind::kMeanAngularSpeed, "mean_spin_rad_s", after.spin,
               MadeUpThrows::kMeasuringError);
      measured(SummaryStatistic::Kind::kMeanScarDepth, "mean_depth_m", after.depth, 0.005);
      study.observations.push_back(impact);
    }
  }

  /// Stops of both shapes and passages of the compact ones, as the field would give them.
  void observe(std::size_t number, const MadeUpSite& site, const std::vector<double>& truth,
               std::size_t count, bool fitted, std::uint64_t seed) {
    Random random(seed);
    for (const std::uint32_t shape : {0u, 1u}) {
      const std::vector<ReleaseOutcome> field = field_releases(site, truth, shape, count, random);
      const std::string name = runs.sites[number].name + (shape == 0 ? " compact" : " elongated");
      Observation stops = blank(name + " stops", number, fitted, shape, count);
      stops.statistics = {{SummaryStatistic::Kind::kMeanStopPosition, 0.0, "mean_place_m", 0.0, {}},
                          {SummaryStatistic::Kind::kStopDeviation, 0.0, "std_place_m", 0.0, {}}};
      observe_figures(stops, field);
      Observation passages = blank(name + " passages", number, fitted, shape, count);
      passages.barrier = "EC";
      passages.statistics = {
          {SummaryStatistic::Kind::kPassedFraction, 0.0, "passed", 0.0, {}},
          {SummaryStatistic::Kind::kMeanSpeed, 0.0, "mean_speed_m_s", 0.0, {}},
          {SummaryStatistic::Kind::kMeanAngularSpeed, 0.0, "mean_spin_rad_s", 0.0, {}}};
      observe_figures(passages, field);
    }
  }

  CalibrationPosterior posterior(unsigned threads = 2) const {
    return infer_posterior(study, runs, threads);
  }

 private:
  static Observation blank(const std::string& name, std::size_t site, bool fitted,
                           std::uint32_t shape, std::size_t count) {
    Observation observation;
    observation.name = name;
    observation.site = site;
    observation.fitted = fitted;
    observation.shape = shape == 0 ? "compact" : "elongated";
    observation.releases = count;
    return observation;
  }
  void observe_figures(Observation& observation, const std::vector<ReleaseOutcome>& field) {
    const std::vector<SelectedOutcome> seen =
        select_outcomes(observation, runs.sites[observation.site], field);
    std::vector<std::size_t> all(seen.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    for (SummaryStatistic& statistic : observation.statistics)
      statistic.observed = compute_statistic(statistic, seen, all);
    study.observations.push_back(observation);
  }
};

/// Does the 95 % interval of an unknown have the truth?
inline bool covers(const MarginalPosterior& marginal, double truth) {
  return marginal.low <= truth && truth <= marginal.high;
}

/// Of the fields of `study_of`.
inline const std::vector<double> kTruth = {0.6, 0.2, 0.05};

/// A study of sites whose blocks go so much farther than those of another.
/// @param bend  how far the law of the field differs from that of the members
inline MadeUpStudy study_of(const std::vector<double>& reaches, std::uint64_t seed = 5,
                            double bend = 0.0) {
  MadeUpStudy made(32, 64, seed);
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    MadeUpSite site;
    site.reach = reaches[i];
    site.seed = seed + i;
    const std::size_t number = made.add_site("site " + std::to_string(i + 1), site);
    site.bend = bend;  // of the field alone
    made.observe(number, site, kTruth, 24, true, 31 * seed + i);
  }
  return made;
}

}  // namespace clast

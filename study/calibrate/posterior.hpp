#pragma once
/// Posterior of a calibration, with diagnostics.
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/statistics/sobol_indices.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/surrogate.hpp"

namespace clast {

/// Simulated releases of all members of a calibration.
struct CalibrationRuns {
  std::vector<SiteDescription> sites;
  /// Simulated releases, by site, then member.
  std::vector<std::vector<std::vector<ReleaseOutcome>>> outcomes;
};

/// Marginal posterior of an unknown parameter, in the unit of the parameter.
struct MarginalPosterior {
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval
  /// Width of the 95 % interval divided by that of the prior, both in prior probability.
  double width = 1.0;
  double fraction_at_low = 0.0,
         /// Fractions of the draws in the lowest and highest 5 % of the prior.
      fraction_at_high = 0.0;

  /// True if the observations hardly constrain the parameter.
  bool is_undetermined() const { return width > 0.8; }
  /// True if a limit of the prior range truncates the posterior.
  bool is_cut_off_by_range() const {
    return !is_undetermined() && (fraction_at_low > 0.25 || fraction_at_high > 0.25);
  }
};

/// Predictive distribution of a summary statistic.
struct PredictedInterval {
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval
};

/// Posterior prediction of an observed statistic, with the prior prediction for comparison.
struct PredictedStatistic {
  std::size_t observation = 0;  ///< index into CalibrationStudy::observations
  std::size_t statistic = 0;    ///< index into the statistics of the observation
  double median = 0.0;
  double low = 0.0,
         high = 0.0;  ///< 95 % interval of the statistic for a sample as large as that of the field
  PredictedInterval prior;  ///< prediction with parameters drawn from their prior

  bool covers(double observed) const { return low <= observed && observed <= high; }
};

/// Posterior predictive check: agreement of the calibrated simulation with the observed statistics.
struct PredictiveCheck {
  std::size_t statistics = 0;  ///< number of statistics
  std::size_t covered = 0;  ///< number of observed statistics inside their predicted 95 % intervals
  /// Squared Mahalanobis distance of observed and predicted statistics.
  double squared_distance = 0.0;
  double degrees_of_freedom = 0.0;  ///< number of statistics minus number of determined parameters
  /// Probability of a larger distance if the model is correct. Empty without degrees of freedom.
  std::optional<double> p_value;

  bool failed() const { return p_value && *p_value < 0.05; }
};

/// Members whose statistics are closest to the observed ones. They are a coarse check of the
/// posterior.
struct NearestMembers {
  std::size_t members = 0;
  std::vector<MarginalPosterior> unknowns;  ///< median, minimum and maximum over these members
};

/// Posterior of the unknown parameters, with predictions and diagnostics.
struct CalibrationPosterior {
  Eigen::MatrixXd probabilities;  ///< posterior draws in prior probability, one column per draw
  Eigen::MatrixXd draws;  ///< posterior draws in the units of the parameters, one column per draw
  Eigen::VectorXd log_likelihood;
  double log_evidence = 0.0;
  std::size_t temperature_count = 0;
  double acceptance_rate = 0.0;
  std::vector<MarginalPosterior> marginals;
  Eigen::MatrixXd correlation;                  ///< rank correlations of the draws
  std::vector<PredictedStatistic> predictions;  ///< one entry per statistic with a surrogate
  PredictiveCheck fitted, held_out;
  /// Statistics of the members, one row per statistic and one column per member; NaN if undefined.
  Eigen::MatrixXd member_statistics;
  /// Quality of the surrogate of each statistic; empty if it has none.
  std::vector<std::optional<SurrogateQuality>> surrogates;
  /// Sensitivity of each statistic to each unknown parameter.
  std::vector<std::vector<SobolIndices>> sensitivities;
  NearestMembers nearest;
};

/// Infers the posterior of the unknown parameters from the simulated members and the observations.
/// @param threads  0: one per core; does not affect the result
/// @throws InputError  if too few members have a value of a fitted statistic, or a site lacks an
///                     observed block or shape
/// @cite gelman1996, beaumont2002
CalibrationPosterior infer_posterior(const CalibrationStudy& study, const CalibrationRuns& runs,
                                     unsigned threads);

}  // namespace clast

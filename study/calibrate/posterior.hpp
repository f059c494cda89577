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
  std::vector<std::vector<std::vector<ReleaseOutcome>>> outcomes;  ///< by site, then member
};

/// Marginal posterior of an unknown, in its own unit.
struct MarginalPosterior {
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval
  /// Width of the 95 % interval divided by that of the prior. Both in prior probability.
  double width = 1.0;
  double fraction_at_low = 0.0,
         fraction_at_high =
             0.0;  ///< fractions of the draws in the lowest and highest 5 % of the prior

  /// True if the data hardly constrain the unknown.
  bool is_undetermined() const { return width > 0.8; }
  /// True if many draws are near a limit of the prior, so that it truncates the posterior.
  bool is_cut_off_by_range() const {
    return !is_undetermined() && (fraction_at_low > 0.25 || fraction_at_high > 0.25);
  }
};

/// Predictive distribution of a statistic.
struct PredictedInterval {
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval
};

/// Posterior prediction of a statistic, compared with the prior prediction.
struct PredictedStatistic {
  std::size_t observation = 0;  ///< index into CalibrationStudy::observations
  std::size_t statistic = 0;    ///< index into its statistics
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval of the value that the field sample would have
  PredictedInterval prior;       ///< the same for unknowns drawn from their prior

  bool covers(double observed) const { return low <= observed && observed <= high; }
};

/// Posterior predictive check: how well the calibrated simulation agrees with observed statistics.
struct PredictiveCheck {
  std::size_t statistics = 0;  ///< number of statistics
  std::size_t covered = 0;     ///< number of statistics inside their 95 % intervals
  double squared_distance =
      0.0;  ///< squared Mahalanobis distance of observed and predicted statistics
  double degrees_of_freedom =
      0.0;  ///< number of statistics minus number of parameters that they determine
  /// Probability of a larger distance if the model is correct. Empty without degrees of freedom.
  std::optional<double> p_value;

  bool failed() const { return p_value && *p_value < 0.05; }
};

/// Members whose statistics are nearest to the observed ones: a coarse check without surrogates.
struct NearestMembers {
  std::size_t members = 0;
  std::vector<MarginalPosterior> unknowns;  ///< median, minimum and maximum over these members
};

/// Posterior of the unknowns, with predictions and diagnostics.
struct CalibrationPosterior {
  Eigen::MatrixXd probabilities;  ///< posterior draws in prior probability, one column per draw
  Eigen::MatrixXd draws;          ///< the same draws in the units of the unknowns
  Eigen::VectorXd log_likelihood;
  double log_evidence = 0.0;
  std::size_t temperature_count = 0;
  double acceptance_rate = 0.0;
  std::vector<MarginalPosterior> marginals;
  Eigen::MatrixXd correlation;                  ///< rank correlations of the draws
  std::vector<PredictedStatistic> predictions;  ///< one entry per statistic with a surrogate
  PredictiveCheck fitted, held_out;
  Eigen::MatrixXd member_statistics;  ///< statistics of each member (rows: statistics, columns:
                                      ///< members); NaN if undefined
  std::vector<std::optional<SurrogateQuality>>
      surrogates;  ///< one entry per statistic; empty if it has no surrogate
  std::vector<std::vector<SobolIndices>> sensitivities;  ///< by statistic, then unknown
  NearestMembers nearest;
};

/// Infers the posterior of the unknowns from the simulated members.
/// @param threads  0: one per core; does not affect the result
/// @throws InputError  if too few members have a value of a fitted statistic, or a site lacks an
///                     observed block or shape
/// @cite gelman1996, beaumont2002
CalibrationPosterior infer_posterior(const CalibrationStudy& study, const CalibrationRuns& runs,
                                     unsigned threads);

}  // namespace clast

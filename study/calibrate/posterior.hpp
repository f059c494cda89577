#pragma once
/// What a calibration finds: the unknowns after the observations, and whether these can be trusted.
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/statistics/sobol_indices.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/surrogate.hpp"

namespace clast {

/// Simulated releases of a calibration.
struct CalibrationRuns {
  std::vector<SiteDescription> sites;
  std::vector<std::vector<std::vector<ReleaseOutcome>>> outcomes;  ///< of each site, each member
};

/// An unknown after the observations, in its own unit.
struct Marginal {
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval
  /// Width of that interval over that of the prior, both in shares of the range.
  double width = 1.0;
  double at_low = 0.0, at_high = 0.0;  ///< shares of the draws in the outermost 5 % of the range

  /// The data say next to nothing of it.
  bool is_undetermined() const { return width > 0.8; }
  /// The range ends where values were still likely.
  bool is_cut_off_by_range() const { return !is_undetermined() && (at_low > 0.25 || at_high > 0.25); }
};

/// What would be observed of a figure.
struct PredictedInterval {
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval
};

/// What the calibrated simulation says of a figure.
struct PredictedStatistic {
  std::size_t observation = 0;  ///< into CalibrationStudy::observations
  std::size_t figure = 0;       ///< into its figures
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval of what would be observed
  PredictedInterval prior;       ///< the same of unknowns anywhere in their ranges

  bool covers(double observed) const { return low <= observed && observed <= high; }
};

/// Are observed figures such as the calibrated simulation gives?
struct PredictiveCheck {
  std::size_t figures = 0;
  std::size_t covered = 0;  ///< by their 95 % intervals
  double squared = 0.0;     ///< squared distance in units of the covariance
  double degrees_of_freedom = 0.0;     ///< figures, less the parameters that they determine
  /// Probability of a larger distance if the law is right; none where as many parameters were
  /// determined as there are figures, so that nothing can contradict.
  std::optional<double> p_value;

  bool failed() const { return p_value && *p_value < 0.05; }
};

/// The members whose figures are nearest to the observed ones: a second opinion, without
/// surrogates, that is coarse.
struct NearestMembers {
  std::size_t members = 0;
  std::vector<Marginal> unknowns;  ///< median, and lowest to highest of them
};

struct CalibrationPosterior {
  Eigen::MatrixXd shares;  ///< draws as shares of the ranges, one column each
  Eigen::MatrixXd draws;   ///< in the units of the unknowns
  Eigen::VectorXd log_likelihood;
  double log_evidence = 0.0;
  std::size_t temperatures = 0;
  double accepted = 0.0;
  std::vector<Marginal> marginals;
  Eigen::MatrixXd correlation;             ///< rank correlations of the draws
  std::vector<PredictedStatistic> predicted;  ///< of the figures that have a surrogate
  PredictiveCheck fitted, kept;
  Eigen::MatrixXd member_figures;  ///< figures by members; not a number where a member has none
  std::vector<std::optional<SurrogateQuality>> surrogates;  ///< of each figure
  std::vector<std::vector<SobolIndices>> sensitivities;     ///< of each figure, each unknown
  NearestMembers nearest;
};

/// @param threads  0: one per core; changes no bit of the result
/// @throws InputError  a fitted figure that too few members have; a site without a block or
///                     shape that is observed
/// @cite gelman1996, beaumont2002
CalibrationPosterior infer_posterior(const CalibrationStudy& study, const CalibrationRuns& runs,
                                     unsigned threads);

}  // namespace clast

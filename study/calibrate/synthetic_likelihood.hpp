#pragma once
/// Synthetic likelihood: probability density of the observed statistics for given unknown
/// parameters.
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/statistic_scatter.hpp"
#include "study/calibrate/surrogate.hpp"

namespace clast::study_detail {

/// Summary statistics of all members, with their random scatter.
struct MemberStatistics {
  Eigen::MatrixXd cube_points;  ///< unknown parameters in the unit cube, one column per member
  Eigen::MatrixXd values;       ///< statistics, one row per statistic and one column per member
  std::vector<SiteStatisticIndices> groups;
  /// Scatter of the statistics, by group, then member.
  std::vector<std::vector<StatisticScatter>> scatter;
};

/// Computes the summary statistics of all members.
/// @param simulated  simulated releases, by site, then member
MemberStatistics compute_member_statistics(
    const CalibrationStudy& study, const std::vector<SiteDescription>& sites,
    const std::vector<std::vector<std::vector<ReleaseOutcome>>>& simulated, unsigned threads);

/// Normal synthetic likelihood. Surrogates predict the means. The covariance is the sum of the
/// covariances of field sample, choice of release points and surrogates.
/// @cite wood2010, kennedy2001
class SyntheticLikelihood {
 public:
  /// Fits the surrogates of all statistics.
  /// @throws InputError  if too few members have a value of a fitted statistic
  SyntheticLikelihood(const CalibrationStudy& study, const MemberStatistics& statistics,
                      unsigned threads);

  /// Returns the indices of the fitted or held-out statistics that have a surrogate.
  std::vector<Eigen::Index> surrogate_indices(bool fitted) const;
  /// Predicted means and surrogate variances of statistics, one row per statistic and one column
  /// per point.
  struct PredictedStatistics {
    Eigen::MatrixXd mean;
    Eigen::MatrixXd variance;
  };
  PredictedStatistics predict_statistics(const Eigen::MatrixXd& cube_points,
                                         const std::vector<Eigen::Index>& which) const;
  Eigen::VectorXd predicted_mean(std::size_t statistic, const Eigen::MatrixXd& cube_points) const;

  /// Returns the log-likelihood of the fitted statistics at each point of the unit cube.
  Eigen::VectorXd log_likelihood(const Eigen::MatrixXd& cube_points) const;
  /// Returns the squared Mahalanobis distance of observed and predicted statistics.
  /// @param fitted  true: fitted statistics; false: held-out statistics
  Eigen::VectorXd squared_distance(const Eigen::MatrixXd& cube_points, bool fitted) const;

  /// Returns the covariance of the given statistics without the surrogate variance.
  Eigen::MatrixXd scatter_covariance(const std::vector<Eigen::Index>& which) const;
  Eigen::VectorXd observed_values(const std::vector<Eigen::Index>& which) const;
  /// Returns the quality of the surrogate of a statistic; empty if it has none.
  std::optional<SurrogateQuality> surrogate_quality(std::size_t statistic) const {
    if (!surrogates_[statistic]) return std::nullopt;
    return surrogates_[statistic]->quality;
  }

 private:
  void estimate_scatter(const MemberStatistics& statistics);
  void pool_scatter(const MemberStatistics& statistics, const Eigen::VectorXd& weights);

  unsigned threads_;
  std::vector<std::optional<Surrogate>> surrogates_;
  std::vector<bool> fitted_;
  Eigen::VectorXd observed_;
  Eigen::MatrixXd scatter_;
};

}  // namespace clast::study_detail

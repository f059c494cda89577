#pragma once
/// Synthetic likelihood: density of the observed statistics as a function of the unknowns.
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/statistic_scatter.hpp"
#include "study/calibrate/surrogate.hpp"

namespace clast::study_detail {

/// Statistics of all members with their scatter.
struct MemberStatistics {
  Eigen::MatrixXd cube_points;  ///< unknowns in the unit cube, one column per member
  Eigen::MatrixXd values;       ///< statistics, one row per statistic and one column per member
  std::vector<SiteStatisticIndices> groups;
  std::vector<std::vector<StatisticScatter>> scatter;  ///< by group, then member
};

/// Computes the statistics of all members.
/// @param simulated  outcomes, by site, then member
MemberStatistics compute_member_statistics(
    const CalibrationStudy& study, const std::vector<SiteDescription>& sites,
    const std::vector<std::vector<std::vector<ReleaseOutcome>>>& simulated, unsigned threads);

/// Normal synthetic likelihood. The means are predicted by the surrogates. The covariance is the
/// sum of the covariances of field sample, choice of release points and surrogates. The first two
/// are those of members near the posterior, which are found iteratively.
/// @cite wood2010, kennedy2001
class SyntheticLikelihood {
 public:
  /// Fits the surrogates.
  /// @throws InputError  if too few members have a value of a fitted statistic
  SyntheticLikelihood(const CalibrationStudy& study, const MemberStatistics& statistics,
                      unsigned threads);

  /// Returns the indices of the statistics with a surrogate, fitted or held-out.
  std::vector<Eigen::Index> surrogate_indices(bool fitted) const;
  /// Predicted means and surrogate variances, one row per statistic and one column per point.
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
  /// Returns the quality of a surrogate; empty if there is none.
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

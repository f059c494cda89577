#pragma once
/// Random scatter of the summary statistics of one member.
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "study/calibrate/observation.hpp"

namespace clast::study_detail {

/// Observations at one site and their statistics, which depend on each other, as indices.
struct SiteStatisticIndices {
  std::vector<std::size_t> observations;  ///< indices into CalibrationStudy::observations
  /// Indices of their statistics, counted over all observations.
  std::vector<std::size_t> statistics;
};
std::vector<SiteStatisticIndices> group_statistics_by_site(
    const std::vector<Observation>& observations);

/// Means and covariances of the statistics of one member at one site. Values are NaN if a statistic
/// is undefined.
struct StatisticScatter {
  /// Expected values for as many releases as were observed in the field.
  Eigen::VectorXd mean;
  /// Covariance for as many releases as were observed in the field. If a statistic has a stated
  /// error, the square of that error is used.
  Eigen::MatrixXd field_covariance;
  /// Covariance due to the limited number of simulated releases.
  Eigen::MatrixXd release_covariance;
  /// Covariance due to the choice of the release points; zero for one point.
  Eigen::MatrixXd point_covariance;
};

/// Estimates the scatter of the statistics of one member at one site, by bootstraps of single
/// releases, of whole release points, and of as many releases as in the field.
/// @param observations  observations of one site
/// @param seen  simulated releases that each observation describes
/// @cite field2007, wood2010
StatisticScatter estimate_statistic_scatter(const std::vector<const Observation*>& observations,
                                            const std::vector<std::vector<SelectedOutcome>>& seen,
                                            std::uint64_t seed);

}  // namespace clast::study_detail

#pragma once
/// Scatter of the summary statistics of one member. Its sources are the small number of field
/// releases, the member's own releases, and the choice of release points.
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "study/calibrate/observation.hpp"

namespace clast::study_detail {

/// Observations of one site, whose statistics are correlated.
struct SiteStatisticIndices {
  std::vector<std::size_t> observations;  ///< indices into CalibrationStudy::observations
  std::vector<std::size_t>
      statistics;  ///< indices of their statistics, counted over all observations
};
std::vector<SiteStatisticIndices> group_statistics_by_site(
    const std::vector<Observation>& observations);

/// Scatter of the statistics of one `SiteStatisticIndices`, in their order. Values are NaN if the
/// member has no value of a statistic.
struct StatisticScatter {
  /// Expected values of a sample as large as the field's. If the error of a statistic is stated,
  /// its value over all releases of the member is used.
  Eigen::VectorXd mean;
  /// Covariance of such samples. If the error of a statistic is stated, its square is used.
  Eigen::MatrixXd field_covariance;
  /// Covariance of the member's statistics under resampling of its releases.
  Eigen::MatrixXd release_covariance;
  /// Covariance of the member's statistics under resampling of release points. Zero for one point.
  Eigen::MatrixXd point_covariance;
};

/// Estimates the scatter by bootstraps of single releases, of whole release points, and of samples
/// as large as the field's. If field releases share start positions, these samples are drawn in
/// clusters. Covariances are scaled to be unbiased. Observations of the same blocks share their
/// draws. Other observations share the release points only.
/// @param observations  observations of one site
/// @param seen  outcomes selected by each observation
/// @cite field2007, wood2010
StatisticScatter estimate_statistic_scatter(const std::vector<const Observation*>& observations,
                                            const std::vector<std::vector<SelectedOutcome>>& seen,
                                            std::uint64_t seed);

}  // namespace clast::study_detail

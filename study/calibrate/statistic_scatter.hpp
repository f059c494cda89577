#pragma once
/// Scatter of the summary statistics of one member: due to the few releases in the field, the
/// member's own releases, and the choice of release points.
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "study/calibrate/observation.hpp"

namespace clast::study_detail {

/// Observations of one site, whose statistics are correlated.
struct SiteStatistics {
  std::vector<std::size_t> observations;  ///< indices into CalibrationStudy::observations
  std::vector<std::size_t> figures;       ///< their statistics, numbered over all observations
};
std::vector<SiteStatistics> group_by_site(const std::vector<Observation>& observations);

/// Scatter of the statistics of one `SiteStatistics`, in their order. NaN if the member has no
/// value.
struct StatisticScatter {
  /// Expected value for a field sample of the observation's size; for stated values, the value over
  /// all releases of the member.
  Eigen::VectorXd mean;
  /// Covariance of such samples; for stated values, the square of the stated error.
  Eigen::MatrixXd field;
  /// Covariance of the member's statistics under resampling of its releases.
  Eigen::MatrixXd within;
  /// Covariance of the member's statistics under resampling of release points; zero for one point.
  Eigen::MatrixXd points;
};

/// Estimates the scatter by bootstraps of single releases, of whole release points, and of samples
/// as large as the field's (in clusters if field releases share starts), scaled to the unbiased
/// variance. Observations of equal blocks, by shape and id, share their draws; others share the
/// release points only.
/// @param observations  of one site
/// @param seen  selected outcomes of each observation
/// @cite field2007, wood2010
StatisticScatter estimate_statistic_scatter(const std::vector<const Observation*>& observations,
                                            const std::vector<std::vector<SelectedOutcome>>& seen,
                                            std::uint64_t seed);

}  // namespace clast::study_detail

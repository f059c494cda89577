#pragma once
/// How figures of one member scatter: with the field's few releases, with the member's own, and
/// with the choice of its release points.
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "study/calibrate/observation.hpp"

namespace clast::study_detail {

/// Observations of one site: their figures scatter together.
struct SiteStatistics {
  std::vector<std::size_t> observations;  ///< into CalibrationStudy::observations
  std::vector<std::size_t> figures;       ///< of these, numbered over all observations
};
std::vector<SiteStatistics> group_by_site(const std::vector<Observation>& observations);

/// Of the figures of a `SiteStatistics`, in their order. Not a number where the member has no value.
struct StatisticScatter {
  /// What a field sample of the observation's size gives on average; of a stated value what all
  /// releases of the member give.
  Eigen::VectorXd mean;
  /// Covariance of such samples; of stated values the square of the stated error.
  Eigen::MatrixXd field;
  /// Covariance of the figures of all the member's releases, were others simulated.
  Eigen::MatrixXd within;
  /// ... were other release points taken. Zero of one point.
  Eigen::MatrixXd points;
};

/// By bootstraps of the releases, scaled to the variance that samples have on average: one by one,
/// by whole release points, and as many as were released in the field, in clusters where field
/// releases share starts. Observations of the same blocks, by shape and id, have the same draws;
/// those of other blocks only the release points.
/// @param observations  of one site
/// @param seen          by each of them
/// @cite field2007, wood2010
StatisticScatter estimate_statistic_scatter(const std::vector<const Observation*>& observations,
                             const std::vector<std::vector<Seen>>& seen, std::uint64_t seed);

}  // namespace clast::study_detail

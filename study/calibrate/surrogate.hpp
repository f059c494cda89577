#pragma once
/// Gaussian-process surrogates, which predict summary statistics for any values of the unknowns.
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/statistics/gaussian_process.hpp"

namespace clast {

struct SurrogateQuality {
  std::size_t members = 0;  ///< number of members for which the statistic is defined
  /// Root mean square leave-one-out error, in the unit of the statistic.
  double leave_one_out_error = 0.0;
  double explained_variance = 0.0;  ///< 1 - error^2 / (variance of the statistic over the members)
  double inflation = 1.0;           ///< factor that scales the predicted variances, at least 1
  double roughness = 0.0;  ///< standard deviation of the residuals in excess of the sampling error
};

}  // namespace clast

namespace clast::study_detail {

/// Gaussian-process surrogate of one summary statistic. Each unknown parameter is given by its
/// cumulative prior probability, in [0, 1].
struct Surrogate {
  GaussianProcess process;
  SurrogateQuality quality;

  /// Predicts means and variances of the statistic at points of the unit cube.
  GaussianProcess::Prediction predict(const Eigen::MatrixXd& cube_points) const;
};

/// Fits the surrogate of one summary statistic.
/// @param cube_points  cumulative prior probabilities of the unknowns, one column per member
/// @param values  value of the statistic of each member; NaN if undefined
/// @param sampling_variance  variance of a value due to the limited number of releases
/// @return empty if the statistic is defined for fewer than `min_members` members
std::optional<Surrogate> fit_surrogate(const Eigen::MatrixXd& cube_points,
                                       const Eigen::VectorXd& values, double sampling_variance,
                                       std::size_t min_members, Kernel kernel);

}  // namespace clast::study_detail

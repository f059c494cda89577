#pragma once
/// The figures of simulations as smooth functions of the unknowns.
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/statistics/gaussian_process.hpp"

namespace clast {

/// How well the surrogate of a figure says members that it has not seen.
struct SurrogateQuality {
  std::size_t members = 0;  ///< that have a value
  double error = 0.0;       ///< root mean square of leave-one-out errors, in the figure's unit
  double explained = 0.0;   ///< share of the variance over members, 1 - error^2/variance
  double inflation = 1.0;   ///< that its variances need to agree with those errors, 1 or more
  double roughness = 0.0;   ///< standard deviation of what is neither smooth nor chance
};

}  // namespace clast

namespace clast::study_detail {

/// A figure over the unit cube of the unknowns.
struct Surrogate {
  GaussianProcess process;
  SurrogateQuality quality;

  /// Means, and variances with the cross-validated error: inflated, and what is not smooth added.
  GaussianProcess::Prediction predict(const Eigen::MatrixXd& places) const;
};

/// @param places  of the members, one column each
/// @param values  of each; not a number where it has none
/// @param chance  variance of a value through the chance of the member's releases
/// @return none where fewer than `fewest` members have a value
std::optional<Surrogate> fit_surrogate(const Eigen::MatrixXd& places, const Eigen::VectorXd& values,
                                       double chance, std::size_t fewest, Kernel kernel);

}  // namespace clast::study_detail

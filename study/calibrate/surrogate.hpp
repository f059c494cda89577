#pragma once
/// Gaussian-process surrogates of summary statistics as functions of the unknowns.
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/statistics/gaussian_process.hpp"

namespace clast {

struct SurrogateQuality {
  std::size_t members = 0;  ///< number of members with a value
  double error = 0.0;  ///< root mean square of the leave-one-out errors, in the statistic's unit
  double explained = 0.0;  ///< 1 - error^2 / variance over the members
  double inflation =
      1.0;  ///< factor by which predicted variances must grow to match the errors, at least 1
  double roughness = 0.0;  ///< standard deviation of the residual that is neither smooth nor random
};

}  // namespace clast

namespace clast::study_detail {

/// Surrogate of a statistic over the unit cube of the unknowns.
struct Surrogate {
  GaussianProcess process;
  SurrogateQuality quality;

  /// Predicts means and variances; variances include the inflation and the roughness found by
  /// cross-validation.
  GaussianProcess::Prediction predict(const Eigen::MatrixXd& places) const;
};

/// Fits a surrogate.
/// @param places  unknowns of the members in the unit cube, one column each
/// @param values  one per member; NaN if undefined
/// @param chance  variance of a value due to the finite number of releases
/// @return empty if fewer than `fewest` members have a value
std::optional<Surrogate> fit_surrogate(const Eigen::MatrixXd& places, const Eigen::VectorXd& values,
                                       double chance, std::size_t fewest, Kernel kernel);

}  // namespace clast::study_detail

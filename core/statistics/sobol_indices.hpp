#pragma once
/// Sobol sensitivity indices.
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace clast {

/// Sobol indices of one input: fractions of the variance of a function. The inputs are independent
/// and uniform in [0, 1).
struct SobolIndices {
  double first_order = 0.0;  ///< fraction due to the input alone
  double total = 0.0;        ///< fraction due to the input and its interactions with other inputs
};

/// Estimates the Sobol indices of all inputs: first order by the estimator of Saltelli et al.,
/// total by that of Jansen. They are clamped to [0, 1], and are 0 for constant functions.
/// @param function  returns the values at points, which are given as columns; it is called for
///                  (inputs + 2) `samples` points in total
/// @param samples  positive; the error of an index is about 2/sqrt(samples)
/// @cite sobol2001, saltelli2010, jansen1999
std::vector<SobolIndices> sobol_indices(
    std::size_t inputs, const std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>& function,
    std::size_t samples, std::uint64_t seed);

}  // namespace clast

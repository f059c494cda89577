#pragma once
/// Which of its inputs a function varies with.
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace clast {

/// Shares of the variance of a function whose inputs are independent and uniform in [0, 1), that go
/// with one of them.
struct SobolIndices {
  double first_order = 0.0;  ///< that goes with the input alone
  double total = 0.0;        ///< that goes with it and with its interplay with others
};

/// Sobol's indices of every input, by the estimators of Saltelli and others for the first order and
/// of Jansen for the total; kept within [0, 1], and 0 of a function that does not vary.
/// @param function  values at places, one column each; (inputs + 2) times `samples` in all
/// @param samples   positive; the error of an index is about 2/sqrt(samples)
/// @cite sobol2001, saltelli2010, jansen1999
std::vector<SobolIndices> sobol_indices(
    std::size_t inputs, const std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>& function,
    std::size_t samples, std::uint64_t seed);

}  // namespace clast

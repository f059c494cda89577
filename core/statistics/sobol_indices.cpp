#include "core/statistics/sobol_indices.hpp"

#include <algorithm>

#include "core/random.hpp"

namespace clast {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_places(std::size_t inputs, std::size_t samples, Random& random) {
  MatrixXd points(static_cast<Index>(inputs), static_cast<Index>(samples));
  for (Index i = 0; i < points.size(); ++i) points.data()[i] = random.uniform();
  return points;
}

}  // namespace

std::vector<SobolIndices> sobol_indices(std::size_t inputs,
                                        const std::function<VectorXd(const MatrixXd&)>& function,
                                        std::size_t samples, std::uint64_t seed) {
  Random random(seed);
  const MatrixXd a = random_places(inputs, samples, random);
  const MatrixXd b = random_places(inputs, samples, random);
  VectorXd at_a = function(a), at_b = function(b);
  // About their mean the products of the first order lose no digits.
  const double mean = 0.5 * (at_a.mean() + at_b.mean());
  at_a.array() -= mean;
  at_b.array() -= mean;
  const auto count = static_cast<double>(samples);
  const double variance = 0.5 * (at_a.squaredNorm() + at_b.squaredNorm()) / count;
  std::vector<SobolIndices> shares(inputs);
  if (!(variance > 0.0)) return shares;
  for (std::size_t i = 0; i < inputs; ++i) {
    MatrixXd mixed = a;
    mixed.row(static_cast<Index>(i)) = b.row(static_cast<Index>(i));
    const VectorXd at_mixed = function(mixed).array() - mean;
    const double first = at_b.dot(at_mixed - at_a) / count;
    const double total = 0.5 * (at_a - at_mixed).squaredNorm() / count;
    shares[i] = {std::clamp(first / variance, 0.0, 1.0), std::clamp(total / variance, 0.0, 1.0)};
  }
  return shares;
}

}  // namespace clast

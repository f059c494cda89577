#pragma once
/// Draws from a distribution over a unit cube of which only the likelihood is known.
#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace clast {

/// Logarithm of the likelihood at places, one column each. Called with many at a time.
using LogLikelihood = std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>;

struct TemperedSamplingOptions {
  std::size_t draws = 2000;
  double effective_fraction =
      0.5;         ///< share of the draws that a step of the temperature leaves effective
  int moves = 10;  ///< of every draw at each temperature
  std::uint64_t seed = 1;

  void check() const;  ///< throws InputError naming the field and its value
};

struct TemperedSample {
  Eigen::MatrixXd points;          ///< one column each, of equal weight
  Eigen::VectorXd log_likelihood;  ///< of each
  double log_evidence = 0.0;       ///< logarithm of the mean likelihood over the cube
  std::size_t temperatures = 0;    ///< that were gone through
  double acceptance_rate = 0.0;    ///< share of the moves at the last temperature
};

/// Tempered sequential Monte Carlo from the uniform distribution over the cube to the one that is
/// proportional to the likelihood: draws are weighted, resampled and moved by Metropolis steps
/// while the likelihood is raised to powers from 0 to 1. Powers follow from the share that stays
/// effective; steps are normal with the covariance of the draws, reflected at the sides, their
/// scale guided to an acceptance near 0.3.
/// @throws InputError  the likelihood is zero, or no number, at all first draws
/// @cite delmoral2006, chopin2002
TemperedSample sample_tempered(std::size_t dimensions, const LogLikelihood& log_likelihood,
                               const TemperedSamplingOptions& options = {});

}  // namespace clast

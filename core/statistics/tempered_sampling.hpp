#pragma once
/// Sampling from a distribution over the unit cube with a given likelihood.
#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace clast {

/// Log-likelihood at points, one column each; called with many points at a time.
using LogLikelihood = std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>;

struct TemperedSamplingOptions {
  std::size_t draws = 2000;
  double effective_fraction = 0.5;  ///< fraction of effective draws that a tempering step keeps
  int moves = 10;                   ///< Metropolis moves per draw and temperature
  std::uint64_t seed = 1;

  void check() const;  ///< throws InputError naming the field and its value
};

struct TemperedSample {
  Eigen::MatrixXd points;          ///< one column each, equally weighted
  Eigen::VectorXd log_likelihood;  ///< one per point
  double log_evidence = 0.0;       ///< logarithm of the mean likelihood over the cube
  std::size_t temperatures = 0;    ///< number of tempering steps
  double acceptance_rate = 0.0;    ///< acceptance rate at the last temperature
};

/// Draws by tempered sequential Monte Carlo from the uniform distribution over the cube to the
/// density proportional to the likelihood: draws are weighted, resampled and moved by Metropolis
/// steps while the likelihood is raised to powers from 0 to 1. Powers follow from the effective
/// fraction; steps are normal with the covariance of the draws, reflected at the sides, and scaled
/// to an acceptance near 0.3.
/// @throws InputError  if the likelihood is zero or NaN at all first draws
/// @cite delmoral2006, chopin2002
TemperedSample sample_tempered(std::size_t dimensions, const LogLikelihood& log_likelihood,
                               const TemperedSamplingOptions& options = {});

}  // namespace clast

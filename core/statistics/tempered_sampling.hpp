#pragma once
/// Sampling from a posterior distribution over the unit cube, given a likelihood.
#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace clast {

/// Returns the log-likelihood at points, given as columns. It is called with many points at a time.
using LogLikelihood = std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>;

struct TemperedSamplingOptions {
  std::size_t draws = 2000;
  double effective_fraction = 0.5;  ///< effective sample size after a tempering step over `draws`
  int moves = 10;                   ///< Metropolis moves per draw and temperature
  std::uint64_t seed = 1;

  void check() const;  ///< throws InputError naming the field and its value
};

struct TemperedSample {
  Eigen::MatrixXd points;           ///< one draw per column, equally weighted
  Eigen::VectorXd log_likelihood;   ///< one per point
  double log_evidence = 0.0;        ///< logarithm of the mean likelihood over the cube
  std::size_t tempering_steps = 0;  ///< number of tempering steps
  double acceptance_rate = 0.0;     ///< acceptance rate at the last temperature
};

/// Draws a sample from the density proportional to the likelihood, by tempered sequential Monte
/// Carlo. It starts from uniform draws in the cube. The likelihood is raised to powers that grow
/// from 0 to 1. At each power, the draws are weighted, resampled and moved by Metropolis steps. The
/// powers follow from the effective fraction. The steps are normal with the covariance of the
/// draws, reflected at the sides, and scaled to an acceptance rate near 0.3.
/// @throws InputError  if the likelihood is zero or NaN at all initial draws
/// @cite delmoral2006, chopin2002
TemperedSample draw_tempered_sample(std::size_t dimensions, const LogLikelihood& log_likelihood,
                                    const TemperedSamplingOptions& options = {});

}  // namespace clast

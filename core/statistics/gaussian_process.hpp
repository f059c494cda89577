#pragma once
/// Gaussian processes: a smooth function of a few numbers out of noisy values at some places of the
/// unit cube, with the error of what it says elsewhere.
#include <Eigen/Core>

namespace clast {

/// How alike the function is at two places r apart, each coordinate in units of its own length.
enum class Kernel {
  kMatern52,            ///< (1 + sqrt(5) r + 5 r^2/3) exp(-sqrt(5) r): twice differentiable
  kSquaredExponential,  ///< exp(-r^2/2): infinitely smooth
};

/// What shapes a process beside its variance and mean, which follow in closed form.
struct GaussianProcessHyperparameters {
  Eigen::VectorXd length_scales;  ///< of each coordinate, in units of the cube's side
  double nugget = 0.0;      ///< variance of the noise over that of the function
};

struct GaussianProcessOptions {
  Kernel kernel = Kernel::kMatern52;
  double min_length_scale = 0.05;         ///< bounds of lengths
  double max_length_scale = 20.0;          ///< from here on the function is next to linear
  double min_nugget = 1e-8;  ///< keeps places that nearly coincide apart
  double max_nugget = 1e3;
  /// Belief that coordinates have little influence: the likelihood is weighed with
  /// exp(-shrinkage/length) of each, so that noise is not taken for an influence.
  double shrinkage = 1.0;
  int iterations = 100;  ///< at most, from each start

  void check() const;  ///< throws InputError naming the field and its value
};

/// A process fitted to values at places. Its mean is a constant that is found with it, so values
/// that are shifted or scaled give a process that is shifted or scaled.
/// @cite rasmussen2006
class GaussianProcess {
 public:
  /// Finds lengths and nugget at the maximum of the marginal likelihood, weighed, by steps that
  /// grow and shrink with the signs of the gradient (Rprop), from two fixed starts: the same bits
  /// every time. Values that are all equal give that value without error.
  /// @param places  one column each, coordinates in [0, 1]
  /// @param values  of each place, finite
  /// @throws InputError  fewer than three places, or not as many values
  /// @cite riedmiller1994, blum2013, fuglstad2019
  GaussianProcess(const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                  const GaussianProcessOptions& options = {});
  /// With a given shape.
  GaussianProcess(const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                  const GaussianProcessHyperparameters& hyperparameters, Kernel kernel);

  const GaussianProcessHyperparameters& hyperparameters() const { return hyperparameters_; }
  double mean() const { return mean_; }
  /// Of the function around its mean.
  double variance() const { return variance_; }
  /// Of one value around the function.
  double noise_variance() const { return variance_ * hyperparameters_.nugget; }
  /// Logarithm of the restricted marginal likelihood, up to a constant.
  double log_likelihood() const { return log_likelihood_; }

  /// At places, one column each: the function, and the variance of its error, without noise.
  struct Prediction {
    Eigen::VectorXd mean;
    Eigen::VectorXd variance;
  };
  Prediction predict(const Eigen::MatrixXd& points) const;
  /// The means alone, which cost far less.
  Eigen::VectorXd predict_mean(const Eigen::MatrixXd& points) const;

  /// Each value from all others, in closed form, with the shape as it is.
  /// @cite dubrule1983
  struct LeaveOneOut {
    Eigen::VectorXd error;     ///< value less what the others say
    Eigen::VectorXd variance;  ///< that it should have, noise and all
  };
  LeaveOneOut leave_one_out() const;

 private:
  void solve();

  Kernel kernel_;
  Eigen::MatrixXd points_;
  Eigen::VectorXd values_;
  GaussianProcessHyperparameters hyperparameters_;
  double mean_ = 0.0, variance_ = 0.0, log_likelihood_ = 0.0;
  Eigen::MatrixXd factor_;   ///< lower triangle of the correlations with the nugget
  Eigen::VectorXd weights_;  ///< inverse correlations times the values about their mean
  Eigen::VectorXd ones_;     ///< inverse correlations times one
};

}  // namespace clast

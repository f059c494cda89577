#pragma once
/// Gaussian process regression of noisy values in the unit cube, with predictive variances.
#include <Eigen/Core>

namespace clast {

/// Correlation as a function of the scaled distance r. Each coordinate has its own length scale.
enum class Kernel {
  kMatern52,            ///< (1 + sqrt(5) r + 5 r^2/3) exp(-sqrt(5) r): twice differentiable
  kSquaredExponential,  ///< exp(-r^2/2): infinitely smooth
};

/// Hyperparameters of a Gaussian process. Its variance and mean follow from them in closed form.
struct GaussianProcessHyperparameters {
  Eigen::VectorXd length_scales;  ///< one per coordinate, in units of the cube side
  double nugget = 0.0;            ///< noise variance divided by process variance
};

struct GaussianProcessOptions {
  Kernel kernel = Kernel::kMatern52;
  double min_length_scale = 0.05;  ///< smallest length scale
  double max_length_scale = 20.0;  ///< largest length scale; the function is then nearly linear
  double min_nugget = 1e-8;        ///< smallest nugget, which keeps the correlation matrix regular
  double max_nugget = 1e3;
  /// Strength of the prior that coordinates have little influence. The likelihood is multiplied by
  /// exp(-shrinkage/length scale) for each coordinate, so that noise is not fitted.
  double shrinkage = 1.0;
  int iterations = 100;  ///< maximum number of iterations from each start

  void check() const;  ///< throws InputError naming the field and its value
};

/// Gaussian process fitted to values at points, with an estimated constant mean. If the values are
/// shifted or scaled, so are the predictions.
/// @cite rasmussen2006
class GaussianProcess {
 public:
  /// Maximises the penalised marginal likelihood over length scales and nugget, by Rprop from two
  /// fixed starts. The result is deterministic. Equal values give a constant without error.
  /// @param points  one point per column, coordinates in [0, 1]
  /// @param values  one per point, finite
  /// @throws InputError  if there are fewer than three points, or if the sizes differ
  /// @cite riedmiller1994, blum2013, fuglstad2019
  GaussianProcess(const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                  const GaussianProcessOptions& options = {});
  GaussianProcess(const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                  const GaussianProcessHyperparameters& hyperparameters, Kernel kernel);

  const GaussianProcessHyperparameters& hyperparameters() const { return hyperparameters_; }
  double mean() const { return mean_; }
  double variance() const { return variance_; }
  double noise_variance() const { return variance_ * hyperparameters_.nugget; }
  /// Returns the restricted log marginal likelihood, up to a constant.
  double log_likelihood() const { return log_likelihood_; }

  /// Predicted mean and variance, one entry per point.
  struct Prediction {
    Eigen::VectorXd mean;
    Eigen::VectorXd variance;  ///< variance of the function, without noise
  };
  Prediction predict(const Eigen::MatrixXd& points) const;
  /// Predicts only the means, which is much cheaper.
  Eigen::VectorXd predict_mean(const Eigen::MatrixXd& points) const;

  /// Leave-one-out predictions in closed form, with unchanged hyperparameters.
  /// @cite dubrule1983
  struct LeaveOneOut {
    Eigen::VectorXd error;     ///< value minus its prediction from the other values
    Eigen::VectorXd variance;  ///< predicted variance of the error, including noise
  };
  LeaveOneOut leave_one_out() const;

 private:
  void solve();

  Kernel kernel_;
  Eigen::MatrixXd points_;
  Eigen::VectorXd values_;
  GaussianProcessHyperparameters hyperparameters_;
  double mean_ = 0.0, variance_ = 0.0, log_likelihood_ = 0.0;
  Eigen::MatrixXd factor_;   ///< Cholesky factor of the correlations with nugget
  Eigen::VectorXd weights_;  ///< inverse correlations times centred values
  Eigen::VectorXd ones_;     ///< inverse correlations times ones
};

}  // namespace clast

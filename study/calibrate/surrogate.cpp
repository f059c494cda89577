#include "study/calibrate/surrogate.hpp"

#include <algorithm>
#include <cmath>

namespace clast::study_detail {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

GaussianProcess::Prediction Surrogate::predict(const MatrixXd& cube_points) const {
  GaussianProcess::Prediction prediction = process.predict(cube_points);
  prediction.variance =
      (quality.inflation * prediction.variance).array() + quality.roughness * quality.roughness;
  return prediction;
}

std::optional<Surrogate> fit_surrogate(const MatrixXd& cube_points, const VectorXd& values,
                                       double sampling_variance, std::size_t min_members,
                                       Kernel kernel) {
  std::vector<Index> with_value;
  for (Index i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) with_value.push_back(i);
  }
  if (with_value.size() < min_members) return std::nullopt;
  const auto count = static_cast<Index>(with_value.size());
  MatrixXd those(cube_points.rows(), count);
  VectorXd known(count);
  for (Index i = 0; i < count; ++i) {
    those.col(i) = cube_points.col(with_value[static_cast<std::size_t>(i)]);
    known[i] = values[with_value[static_cast<std::size_t>(i)]];
  }
  GaussianProcessOptions options;
  options.kernel = kernel;
  Surrogate surrogate{GaussianProcess(those, known, options), {}};
  const GaussianProcess& process = surrogate.process;
  const GaussianProcess::LeaveOneOut left = process.leave_one_out();
  const double variance = (known.array() - known.mean()).square().mean();
  SurrogateQuality& quality = surrogate.quality;
  quality.members = with_value.size();
  quality.leave_one_out_error = std::sqrt(left.error.squaredNorm() / static_cast<double>(count));
  if (variance > 0.0) {
    quality.explained_variance =
        1.0 - quality.leave_one_out_error * quality.leave_one_out_error / variance;
    quality.inflation =
        std::max(1.0, (left.error.array().square() / left.variance.array().max(1e-300)).mean());
  }
  quality.roughness =
      std::sqrt(std::max(0.0, process.noise_variance() - std::max(0.0, sampling_variance)));
  return surrogate;
}

}  // namespace clast::study_detail

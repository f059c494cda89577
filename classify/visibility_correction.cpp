#include "classify/visibility_correction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "classify/size_draws.hpp"
#include "core/statistics/probability.hpp"
#include "core/statistics/statistics.hpp"
#include "core/statistics/tempered_sampling.hpp"

namespace clast {
namespace {

constexpr std::size_t kSpacings = 9;       ///< quantiles of the spacing
constexpr std::size_t kMostFitted = 1000;  ///< blocks to which the model is fitted
constexpr double kLargestMean = 4.0;       ///< visible area over I^2
constexpr double kSmallestMean = -2.0;     ///< likewise, of blocks that are mostly hidden
constexpr double kSlope = 0.4, kSlopeDeviation = 0.25;             ///< prior of the slope
constexpr double kDeviation = 0.65, kLogDeviationDeviation = 0.1;  ///< prior of the deviation
constexpr double kLeastTail = 1e-300;

/// Visible area of a found block, and the area that it must have to be found, over I^2.
struct VisibleArea {
  double log_size = 0.0;  ///< ln I less its mean
  double area = 0.0;
  double limit = 0.0;
};

double relative_area(double points, double spacing, double intermediate) {
  return points * spacing * spacing / (intermediate * intermediate);
}

/// Least visible area of a block that is found, over I^2.
double least_area(double spacing, double intermediate, double surface_ratio) {
  constexpr auto kPoints = static_cast<double>(VisibilityCorrection::kLeastPoints);
  return std::max(relative_area(kPoints, spacing, intermediate),
                  VisibilityCorrection::kLeastVisibleFraction * surface_ratio);
}

/// Maps a point of the unit cube to a model, by the quantiles of its prior.
VisibleAreaModel model_at(const Eigen::VectorXd& point) {
  const auto score = [&](Eigen::Index i) {
    return normal_quantile(std::clamp(point[i], 1e-9, 1.0 - 1e-9));
  };
  return {kSmallestMean + (kLargestMean - kSmallestMean) * point[0],
          kSlope + kSlopeDeviation * score(1),
          kDeviation * std::exp(kLogDeviationDeviation * score(2))};
}

double log_likelihood(const VisibleAreaModel& model, std::span<const VisibleArea> areas) {
  double sum = 0.0;
  for (const VisibleArea& one : areas) {
    const double mean = model.mean + model.slope * one.log_size;
    const double z = (one.area - mean) / model.deviation;
    const double found = normal_cdf((mean - one.limit) / model.deviation);
    sum += -0.5 * z * z - std::log(model.deviation) - std::log(std::max(found, kLeastTail));
  }
  return sum;
}

std::vector<double> find_quantiles(std::vector<double> values, std::size_t count) {
  std::sort(values.begin(), values.end());
  std::vector<double> quantiles;
  for (std::size_t k = 0; k < count; ++k) {
    quantiles.push_back(
        quantile(values, (static_cast<double>(k) + 0.5) / static_cast<double>(count)));
  }
  return quantiles;
}

}  // namespace

double VisibilityCorrection::inclusion_probability(double intermediate) const {
  assert(intermediate > 0.0 && !spacings.empty());
  const double mean = model.mean + model.slope * std::log(intermediate / middle_size);
  double sum = 0.0;
  for (const double spacing : spacings) {
    sum += normal_cdf((mean - least_area(spacing, intermediate, surface_ratio)) / model.deviation);
  }
  return kMostFound * std::max(kLeastProbability, sum / static_cast<double>(spacings.size()));
}

VisibilityCorrection VisibilityCorrection::with_draw(std::size_t index) const {
  VisibilityCorrection drawn = *this;
  drawn.model = draws[index % draws.size()];
  drawn.draws.clear();
  return drawn;
}

VisibilityCorrection fit_visibility_correction(std::span<const MeasuredBlock> blocks,
                                               std::uint64_t seed, std::size_t draws) {
  assert(!blocks.empty() && draws > 0);
  VisibilityCorrection fit;
  std::vector<double> spacings, ratios;
  double log_size = 0.0;
  for (const MeasuredBlock& block : blocks) {
    const DepositObservation& seen = *block.deposit;
    const double size = median_block_sizes(block).axes.I;
    log_size += std::log(size) / static_cast<double>(blocks.size());
    spacings.push_back(seen.spacing);
    ratios.push_back(relative_area(static_cast<double>(seen.points), seen.spacing, size) /
                     std::max(seen.visible_fraction, 1e-3));
  }
  fit.middle_size = std::exp(log_size);
  fit.surface_ratio = upper_median(ratios);
  fit.spacings = find_quantiles(spacings, kSpacings);

  std::vector<VisibleArea> areas;
  const std::size_t count = std::min(blocks.size(), kMostFitted);
  for (std::size_t k = 0; k < count; ++k) {
    const MeasuredBlock& block = blocks[k * blocks.size() / count];
    const DepositObservation& seen = *block.deposit;
    VisibleArea one;
    const double size = median_block_sizes(block).axes.I;
    one.log_size = std::log(size / fit.middle_size);
    one.area = relative_area(static_cast<double>(seen.points), seen.spacing, size);
    one.limit = std::min(one.area, least_area(seen.spacing, size, fit.surface_ratio));
    areas.push_back(one);
  }
  const TemperedSample sample =
      draw_tempered_sample(3,
                           [&](const Eigen::MatrixXd& points) {
                             Eigen::VectorXd logs(points.cols());
                             for (Eigen::Index k = 0; k < points.cols(); ++k) {
                               logs[k] = log_likelihood(model_at(points.col(k)), areas);
                             }
                             return logs;
                           },
                           {.draws = draws, .seed = seed});
  for (std::size_t k = 0; k < draws; ++k) {
    fit.draws.push_back(model_at(sample.points.col(static_cast<Eigen::Index>(k))));
    const double weight = 1.0 / static_cast<double>(draws);
    if (k == 0) fit.model = {0.0, 0.0, 0.0};
    fit.model.mean += weight * fit.draws.back().mean;
    fit.model.slope += weight * fit.draws.back().slope;
    fit.model.deviation += weight * fit.draws.back().deviation;
  }
  return fit;
}

}  // namespace clast

#include "core/statistics/axial_statistics.hpp"

#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "core/types.hpp"

namespace clast {
namespace {

/// Resultants shorter than this are what sums of opposite directions leave by rounding.
constexpr double kNoDirection = 1e-12;
/// Draws that differ from what was observed by no more than rounding count as as long.
constexpr double kRounding = 1e-12;

Vec2 doubled(double angle) { return {std::cos(2.0 * angle), std::sin(2.0 * angle)}; }

}  // namespace

double wrap_axial_angle(double angle) {
  double folded = angle - kPi * std::floor(angle / kPi);  // [0, pi)
  if (folded > 0.5 * kPi) folded -= kPi;
  return folded;
}

AxialMean axial_mean(std::span<const double> angles) {
  AxialMean mean;
  mean.count = angles.size();
  if (angles.empty()) return mean;
  Vec2 sum = Vec2::Zero();
  for (const double angle : angles) sum += doubled(angle);
  mean.resultant_length = sum.norm() / static_cast<double>(angles.size());
  if (mean.resultant_length > kNoDirection) {
    mean.direction = wrap_axial_angle(0.5 * std::atan2(sum.y(), sum.x()));
  }
  return mean;
}

double rayleigh_p_value(const AxialMean& mean) {
  if (mean.count == 0) return 1.0;
  const auto n = static_cast<double>(mean.count);
  const double squared = mean.resultant_length * mean.resultant_length;
  const double statistic = (1.0 - 0.5 / n) * 2.0 * n * squared + 0.5 * n * squared * squared;
  return std::exp(-0.5 * statistic);  // chi-squared with two degrees of freedom
}

std::optional<double> clustered_rayleigh_p_value(const ClusteredValues& angles,
                                                 std::size_t cluster_count, std::uint64_t seed,
                                                 std::size_t draws) {
  std::vector<Vec2> sums(cluster_count, Vec2::Zero());
  std::vector<bool> has_axes(cluster_count, false);
  for (std::size_t i = 0; i < angles.values.size(); ++i) {
    sums[angles.clusters[i]] += doubled(angles.values[i]);
    has_axes[angles.clusters[i]] = true;
  }
  std::size_t with_axes = 0;
  double most = 0.0;
  Vec2 observed = Vec2::Zero();
  for (std::size_t i = 0; i < cluster_count; ++i) {
    with_axes += has_axes[i];
    observed += sums[i];
    most += sums[i].norm();
  }
  if (with_axes < 2) return std::nullopt;
  const double limit = observed.norm() - kRounding * most;
  Random random(seed);
  std::size_t as_long = 0;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    Vec2 sum = Vec2::Zero();
    for (const Vec2& of_cluster : sums) {
      const double turn = random.uniform(0.0, 2.0 * kPi);
      sum += of_cluster.norm() * Vec2(std::cos(turn), std::sin(turn));
    }
    as_long += sum.norm() >= limit;
  }
  return static_cast<double>(1 + as_long) / static_cast<double>(1 + draws);
}

}  // namespace clast

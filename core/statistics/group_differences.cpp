#include "core/statistics/group_differences.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/random.hpp"

namespace clast {
namespace {

struct Sum {
  double sum = 0.0;
  std::size_t count = 0;

  void add(const Sum& other) {
    sum += other.sum;
    count += other.count;
  }
  double mean() const { return sum / static_cast<double>(count); }
};

/// Sum and count of every cluster; of every value where there is one cluster.
std::vector<Sum> pieces_of(const ClusteredValues& group, std::size_t clusters) {
  std::vector<Sum> pieces(clusters > 1 ? clusters : group.values.size());
  for (std::size_t i = 0; i < group.values.size(); ++i) {
    pieces[clusters > 1 ? group.clusters[i] : i].add({group.values[i], 1});
  }
  return pieces;
}

double squares_of(std::span<const double> values) {
  const double mean = arithmetic_mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum;
}

}  // namespace

std::vector<double> holm(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return p_values[i] < p_values[j]; });
  std::vector<double> corrected(p_values.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double left = static_cast<double>(order.size() - i);
    largest = std::max(largest, std::min(1.0, left * p_values[order[i]]));
    corrected[order[i]] = largest;
  }
  return corrected;
}

std::optional<double> cliffs_delta(std::span<const double> a, std::span<const double> b) {
  if (a.empty() || b.empty()) return std::nullopt;
  std::vector<double> sorted(b.begin(), b.end());
  std::sort(sorted.begin(), sorted.end());
  double balance = 0.0;
  for (const double value : a) {
    const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), value);
    balance += static_cast<double>(low - sorted.begin()) - static_cast<double>(sorted.end() - high);
  }
  return balance / (static_cast<double>(a.size()) * static_cast<double>(b.size()));
}

const char* words_for_delta(double delta) {
  const double size = std::abs(delta);
  return size < 0.147 ? "negligible" : size < 0.33 ? "small" : size < 0.474 ? "medium" : "large";
}

std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b) {
  if (a.size() < 2 || b.size() < 2) return std::nullopt;
  const double freedom = static_cast<double>(a.size() + b.size() - 2);
  const double pooled = std::sqrt((squares_of(a) + squares_of(b)) / freedom);
  if (!(pooled > 0.0)) return std::nullopt;
  return (1.0 - 3.0 / (4.0 * freedom - 1.0)) * (arithmetic_mean(a) - arithmetic_mean(b)) / pooled;
}

Interval percentile_interval(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.025), quantile(values, 0.975)};
}

std::optional<Interval> bootstrap_difference(const ClusteredValues& a, const ClusteredValues& b,
                                             std::size_t clusters, std::uint64_t seed,
                                             std::size_t draws) {
  if (a.values.empty() || b.values.empty()) return std::nullopt;
  const std::vector<Sum> of_a = pieces_of(a, clusters), of_b = pieces_of(b, clusters);
  Random random(seed);
  std::vector<double> differences;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    Sum sum_a, sum_b;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      const std::size_t cluster = random.below(of_a.size());
      sum_a.add(of_a[cluster]);
      if (clusters > 1) sum_b.add(of_b[cluster]);
    }
    if (clusters <= 1) {
      for (std::size_t i = 0; i < of_b.size(); ++i) sum_b.add(of_b[random.below(of_b.size())]);
    }
    // Clusters that one group has nothing in can leave it empty.
    if (sum_a.count > 0 && sum_b.count > 0) differences.push_back(sum_a.mean() - sum_b.mean());
  }
  if (differences.size() < draws / 2) return std::nullopt;
  return percentile_interval(std::move(differences));
}

std::optional<Interval> bootstrap_mean(const ClusteredValues& values, std::size_t clusters,
                                       std::uint64_t seed, std::size_t draws) {
  if (values.values.empty()) return std::nullopt;
  std::vector<Sum> pieces = pieces_of(values, clusters);
  std::erase_if(pieces, [](const Sum& piece) { return piece.count == 0; });
  Random random(seed);
  std::vector<double> means;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    Sum sum;
    for (std::size_t i = 0; i < pieces.size(); ++i) sum.add(pieces[random.below(pieces.size())]);
    means.push_back(sum.mean());
  }
  return percentile_interval(std::move(means));
}

Interval clustered_share_interval(const ClusteredValues& hits, std::size_t clusters) {
  const auto trials = static_cast<double>(hits.values.size());
  if (hits.values.empty()) return {};
  const double share = arithmetic_mean(hits.values);
  double squares = 0.0, filled = 0.0;
  if (clusters > 1) {
    for (const Sum& piece : pieces_of(hits, clusters)) {
      if (piece.count == 0) continue;
      const double off = piece.sum - share * static_cast<double>(piece.count);
      squares += off * off;
      ++filled;
    }
  }
  double independent = trials;
  if (filled > 1.0 && squares > 0.0) {
    const double variance = filled / (filled - 1.0) * squares / (trials * trials);
    independent = std::min(trials, share * (1.0 - share) / variance);
  }
  return wilson_interval_of_share(share, independent);
}

}  // namespace clast

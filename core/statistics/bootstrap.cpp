#include "core/statistics/bootstrap.hpp"

#include <algorithm>
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
std::vector<Sum> pieces_of(const ClusteredValues& group, std::size_t cluster_count) {
  std::vector<Sum> pieces(cluster_count > 1 ? cluster_count : group.values.size());
  for (std::size_t i = 0; i < group.values.size(); ++i) {
    pieces[cluster_count > 1 ? group.clusters[i] : i].add({group.values[i], 1});
  }
  return pieces;
}

}  // namespace

Interval percentile_interval(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.025), quantile(values, 0.975)};
}

std::optional<Interval> bootstrap_difference_interval(const ClusteredValues& a,
                                                      const ClusteredValues& b,
                                                      std::size_t cluster_count, std::uint64_t seed,
                                                      std::size_t draws) {
  if (a.values.empty() || b.values.empty()) return std::nullopt;
  const std::vector<Sum> of_a = pieces_of(a, cluster_count), of_b = pieces_of(b, cluster_count);
  Random random(seed);
  std::vector<double> differences;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    Sum sum_a, sum_b;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      const std::size_t cluster = random.uniform_index(of_a.size());
      sum_a.add(of_a[cluster]);
      if (cluster_count > 1) sum_b.add(of_b[cluster]);
    }
    if (cluster_count <= 1) {
      for (std::size_t i = 0; i < of_b.size(); ++i)
        sum_b.add(of_b[random.uniform_index(of_b.size())]);
    }
    // Clusters that one group has nothing in can leave it empty.
    if (sum_a.count > 0 && sum_b.count > 0) differences.push_back(sum_a.mean() - sum_b.mean());
  }
  if (differences.size() < draws / 2) return std::nullopt;
  return percentile_interval(std::move(differences));
}

std::optional<Interval> bootstrap_mean_interval(const ClusteredValues& values,
                                                std::size_t cluster_count, std::uint64_t seed,
                                                std::size_t draws) {
  if (values.values.empty()) return std::nullopt;
  std::vector<Sum> pieces = pieces_of(values, cluster_count);
  std::erase_if(pieces, [](const Sum& piece) { return piece.count == 0; });
  Random random(seed);
  std::vector<double> means;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    Sum sum;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      sum.add(pieces[random.uniform_index(pieces.size())]);
    means.push_back(sum.mean());
  }
  return percentile_interval(std::move(means));
}

Interval clustered_proportion_interval(const ClusteredValues& hits, std::size_t cluster_count) {
  const auto trials = static_cast<double>(hits.values.size());
  if (hits.values.empty()) return {};
  const double share = arithmetic_mean(hits.values);
  double squares = 0.0, filled = 0.0;
  if (cluster_count > 1) {
    for (const Sum& piece : pieces_of(hits, cluster_count)) {
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
  return wilson_interval_of_proportion(share, independent);
}

}  // namespace clast

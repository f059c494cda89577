#include "core/statistics/clustered_test.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "core/random.hpp"

namespace clast {
namespace {

/// Values of both samples in ascending order, their clusters, and the sample assigned to each.
class Deal {
 public:
  Deal(const ClusteredValues& a, const ClusteredValues& b, std::size_t cluster_count) {
    const std::size_t m = a.values.size(), all = m + b.values.size();
    std::vector<std::size_t> order(all);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto value = [&](std::size_t i) { return i < m ? a.values[i] : b.values[i - m]; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return value(i) < value(j); });
    std::vector<std::vector<std::size_t>> members(cluster_count);
    first_.resize(all);
    ends_.resize(all);
    for (std::size_t at = 0; at < all; ++at) {
      const std::size_t i = order[at];
      first_[at] = i < m;
      ends_[at] = at + 1 == all || value(order[at + 1]) != value(i);
      members[i < m ? a.clusters[i] : b.clusters[i - m]].push_back(at);
    }
    for (std::vector<std::size_t>& points : members) {
      if (points.empty()) continue;
      const auto of_first = static_cast<std::size_t>(
          std::count_if(points.begin(), points.end(), [&](std::size_t at) { return first_[at]; }));
      if (of_first > 0 && of_first < points.size()) {
        shared_.push_back({std::move(points), of_first});
      } else {
        alone_of_first_ += of_first > 0 ? 1 : 0;
        alone_.push_back(std::move(points));
      }
    }
  }

  bool all_shared() const { return alone_.empty(); }

  double distance() const {
    const std::int64_t m = std::count(first_.begin(), first_.end(), 1);
    const std::int64_t n = static_cast<std::int64_t>(first_.size()) - m;
    std::int64_t off = 0, largest = 0;  // in units of 1/(m n), so that equal distances are equal
    for (std::size_t at = 0; at < first_.size(); ++at) {
      off += first_[at] ? n : -m;
      if (ends_[at]) largest = std::max(largest, std::abs(off));
    }
    return static_cast<double>(largest) / (static_cast<double>(m) * static_cast<double>(n));
  }

  void deal_anew(Random& random) {
    for (Shared& cluster : shared_) {
      put_in_front(cluster.points, cluster.of_first, random);
      for (std::size_t i = 0; i < cluster.points.size(); ++i) {
        first_[cluster.points[i]] = i < cluster.of_first;
      }
    }
    put_in_front(alone_, alone_of_first_, random);
    for (std::size_t i = 0; i < alone_.size(); ++i) {
      for (const std::size_t at : alone_[i]) first_[at] = i < alone_of_first_;
    }
  }

 private:
  struct Shared {
    std::vector<std::size_t> points;
    std::size_t of_first = 0;  ///< how many the first sample has
  };
  /// Puts `count` of the items, drawn at random, in front.
  template <class T>
  static void put_in_front(std::vector<T>& items, std::size_t count, Random& random) {
    for (std::size_t i = 0; i < count; ++i) {
      std::swap(items[i], items[i + random.uniform_index(items.size() - i)]);
    }
  }

  std::vector<char> first_;  ///< of each value: whether the first sample has it
  std::vector<char> ends_;   ///< ... and whether the next one is larger
  std::vector<Shared> shared_;
  std::vector<std::vector<std::size_t>> alone_;  ///< clusters of one sample only
  std::size_t alone_of_first_ = 0;
};

}  // namespace

std::optional<TestResult> clustered_ks_test(const ClusteredValues& a, const ClusteredValues& b,
                                            std::size_t cluster_count, std::uint64_t seed,
                                            std::size_t draws) {
  if (cluster_count <= 1 || a.values.empty() || b.values.empty()) {
    return two_sample_ks_test(a.values, b.values);
  }
  Deal deal(a, b, cluster_count);
  TestResult result;
  result.exact = false;
  result.statistic = deal.distance();
  std::size_t as_far = 0;
  Random random(seed);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    deal.deal_anew(random);
    as_far += deal.distance() >= result.statistic ? 1 : 0;
  }
  result.p_value = static_cast<double>(1 + as_far) / static_cast<double>(1 + draws);
  if (as_far == 0 && deal.all_shared()) {
    result.p_value = std::min(result.p_value, two_sample_ks_test(a.values, b.values)->p_value);
  }
  return result;
}

}  // namespace clast

#include "study/calibrate/statistic_scatter.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "core/random.hpp"

namespace clast::study_detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sample = std::vector<std::size_t>;  ///< places in the rows that an observation sees

constexpr std::size_t kScatterDraws = 200;
constexpr std::size_t kMinScatterDraws =
    10;  ///< with a value, that a mean or covariance is taken of
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The releases of a member that some observations have in common.
struct SharedReleases {
  std::size_t rows = 0;
  std::map<std::uint32_t, Sample> by_point;
  std::size_t maximum = 0;            ///< field releases, of any of the observations
  std::vector<std::size_t> clusters;  ///< of the field releases
};

/// All blocks of a site that are observed, and which of them each observation is of.
struct SiteBlocks {
  std::vector<SharedReleases> blocks;
  std::vector<std::size_t> of_observation;
  std::vector<std::uint32_t> points;
};

SiteBlocks blocks_of(const std::vector<const Observation*>& observations,
                     const std::vector<std::vector<SelectedOutcome>>& seen) {
  SiteBlocks site;
  std::map<std::array<std::string, 3>, std::size_t> numbers;
  std::set<std::uint32_t> points;
  for (std::size_t o = 0; o < observations.size(); ++o) {
    const Observation& own = *observations[o];
    const auto [number, is_new] =
        numbers.emplace(std::array{own.shape, own.block, own.release}, site.blocks.size());
    site.of_observation.push_back(number->second);
    if (is_new) {
      site.blocks.push_back({seen[o].size(), {}, 0, {}});
      for (std::size_t i = 0; i < seen[o].size(); ++i) {
        site.blocks.back().by_point[seen[o][i].point].push_back(i);
        points.insert(seen[o][i].point);
      }
    }
    SharedReleases& blocks = site.blocks[number->second];
    blocks.maximum = std::max(blocks.maximum, own.releases);
    if (blocks.clusters.empty()) blocks.clusters = own.clusters;
  }
  site.points.assign(points.begin(), points.end());
  return site;
}

/// Statistics of the sampled releases; each observation uses the first ones, as many as it had.
/// @param whole  all of the sample for every observation
VectorXd figures_of(const std::vector<const Observation*>& observations,
                    const std::vector<std::vector<SelectedOutcome>>& seen, const SiteBlocks& site,
                    const std::vector<Sample>& samples, bool whole) {
  std::vector<double> values;
  for (std::size_t o = 0; o < observations.size(); ++o) {
    const std::span<const std::size_t> all(samples[site.of_observation[o]]);
    const std::size_t count = whole ? all.size() : observations[o]->releases;
    for (const SummaryStatistic& statistic : observations[o]->statistics) {
      values.push_back(
          compute_statistic(statistic, seen[o], all.first(std::min(count, all.size()))));
    }
  }
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

struct SolidMoments {
  VectorXd mean;
  MatrixXd covariance;
};

/// Each over the draws that have the values.
SolidMoments moments_of(const std::vector<VectorXd>& draws) {
  const Index count = draws.front().size();
  SolidMoments moments{VectorXd::Constant(count, kNone), MatrixXd::Constant(count, count, kNone)};
  const auto mean_over = [&](const std::function<double(const VectorXd&)>& value) {
    double sum = 0.0;
    std::size_t finite = 0;
    for (const VectorXd& draw : draws) {
      const double one = value(draw);
      if (one != one) continue;
      sum += one;
      ++finite;
    }
    return finite < kMinScatterDraws ? kNone : sum / static_cast<double>(finite);
  };
  for (Index i = 0; i < count; ++i) {
    moments.mean[i] = mean_over([&](const VectorXd& draw) { return draw[i]; });
  }
  for (Index i = 0; i < count; ++i) {
    for (Index k = 0; k <= i; ++k) {
      moments.covariance(i, k) = moments.covariance(k, i) = mean_over([&](const VectorXd& draw) {
        return (draw[i] - moments.mean[i]) * (draw[k] - moments.mean[k]);
      });
    }
  }
  return moments;
}

using DrawSamples = std::function<std::vector<Sample>()>;

SolidMoments bootstrap_moments(const std::vector<const Observation*>& observations,
                               const std::vector<std::vector<SelectedOutcome>>& seen,
                               const SiteBlocks& site, bool whole, const DrawSamples& draw) {
  std::vector<VectorXd> draws;
  for (std::size_t i = 0; i < kScatterDraws; ++i) {
    draws.push_back(figures_of(observations, seen, site, draw(), whole));
  }
  return moments_of(draws);
}

Sample one_by_one(const SharedReleases& blocks, std::size_t count, Random& random) {
  Sample sample;
  if (blocks.rows == 0) return sample;
  for (std::size_t i = 0; i < count; ++i) sample.push_back(random.uniform_index(blocks.rows));
  return sample;
}

Sample as_in_field(const SharedReleases& blocks, Random& random) {
  if (blocks.clusters.empty() || blocks.rows == 0)
    return one_by_one(blocks, blocks.maximum, random);
  Sample sample;
  for (const std::size_t count : blocks.clusters) {
    const auto point =
        std::next(blocks.by_point.begin(),
                  static_cast<std::ptrdiff_t>(random.uniform_index(blocks.by_point.size())));
    for (std::size_t i = 0; i < count; ++i) {
      sample.push_back(point->second[random.uniform_index(point->second.size())]);
    }
  }
  return sample;
}

std::vector<Sample> by_points(const SiteBlocks& site, Random& random) {
  std::vector<Sample> samples(site.blocks.size());
  for (std::size_t i = 0; i < site.points.size(); ++i) {
    const std::uint32_t point = site.points[random.uniform_index(site.points.size())];
    for (std::size_t b = 0; b < site.blocks.size(); ++b) {
      const auto rows = site.blocks[b].by_point.find(point);
      if (rows == site.blocks[b].by_point.end()) continue;
      samples[b].insert(samples[b].end(), rows->second.begin(), rows->second.end());
    }
  }
  return samples;
}

/// The variance of means of a sample drawn from n others, with replacement, over the variance that
/// this has on average: of one nothing is known.
double bootstrap_factor(std::size_t n) {
  const auto count = static_cast<double>(n);
  return n < 2 ? 1.0 : count / (count - 1.0);
}

/// Scales the covariance of the figures of each observation by the factors of their blocks.
void make_unbiased(const std::vector<const Observation*>& observations, const SiteBlocks& site,
                   const std::vector<std::size_t>& drawn_from, MatrixXd& covariance) {
  std::vector<double> roots;
  for (std::size_t o = 0; o < observations.size(); ++o) {
    const double factor = bootstrap_factor(drawn_from[site.of_observation[o]]);
    roots.insert(roots.end(), observations[o]->statistics.size(), std::sqrt(factor));
  }
  const auto root = Eigen::Map<const VectorXd>(roots.data(), static_cast<Index>(roots.size()));
  covariance = root.asDiagonal() * covariance * root.asDiagonal();
}

/// Factor of the variance for few points. A bootstrap of n points gives (n - 1)/n of the variance,
/// which is itself an estimate: it follows Student's t with n - 1 degrees of freedom, whose
/// variance is (n - 1)/(n - 3) times as large. Fewer than four points are treated as four.
double few_points_factor(std::size_t points) {
  const auto count = static_cast<double>(std::max<std::size_t>(points, 4));
  return count / (count - 3.0);
}

/// Stated values do not come from a sample.
void put_stated(const std::vector<const Observation*>& observations, const VectorXd& whole,
                StatisticScatter& scatter) {
  Index at = 0;
  for (const Observation* observation : observations) {
    for (const SummaryStatistic& statistic : observation->statistics) {
      const bool unbiased = statistic.kind != SummaryStatistic::Kind::kStopDeviation &&
                            statistic.kind != SummaryStatistic::Kind::kStopQuantile;
      if (statistic.error || unbiased) scatter.mean[at] = whole[at];
      if (statistic.error) {
        scatter.field_covariance.row(at).setZero();
        scatter.field_covariance.col(at).setZero();
        scatter.field_covariance(at, at) = *statistic.error * *statistic.error;
      }
      scatter.field_covariance(at, at) += statistic.measurement_error * statistic.measurement_error;
      ++at;
    }
  }
}

}  // namespace

std::vector<SiteStatisticIndices> group_statistics_by_site(
    const std::vector<Observation>& observations) {
  std::vector<SiteStatisticIndices> groups;
  std::size_t statistic = 0;
  for (std::size_t o = 0; o < observations.size(); ++o) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const SiteStatisticIndices& other) {
      return observations[other.observations.front()].site == observations[o].site;
    });
    if (group == groups.end()) group = groups.insert(groups.end(), SiteStatisticIndices());
    group->observations.push_back(o);
    for (std::size_t i = 0; i < observations[o].statistics.size(); ++i) {
      group->statistics.push_back(statistic++);
    }
  }
  return groups;
}

StatisticScatter estimate_statistic_scatter(const std::vector<const Observation*>& observations,
                                            const std::vector<std::vector<SelectedOutcome>>& seen,
                                            std::uint64_t seed) {
  const SiteBlocks site = blocks_of(observations, seen);
  std::vector<Sample> all;
  for (const SharedReleases& blocks : site.blocks) {
    all.emplace_back(blocks.rows);
    std::iota(all.back().begin(), all.back().end(), std::size_t{0});
  }
  const VectorXd whole = figures_of(observations, seen, site, all, true);
  Random random(seed);
  const auto of_each = [&](const std::function<Sample(const SharedReleases&)>& draw) {
    std::vector<Sample> samples;
    for (const SharedReleases& blocks : site.blocks) samples.push_back(draw(blocks));
    return samples;
  };
  SolidMoments field = bootstrap_moments(observations, seen, site, false, [&] {
    return of_each([&](const SharedReleases& blocks) { return as_in_field(blocks, random); });
  });
  SolidMoments within = bootstrap_moments(observations, seen, site, true, [&] {
    return of_each(
        [&](const SharedReleases& blocks) { return one_by_one(blocks, blocks.rows, random); });
  });
  std::vector<std::size_t> rows, field_draws;
  for (const SharedReleases& blocks : site.blocks) {
    rows.push_back(blocks.rows);
    const bool by_point = !blocks.clusters.empty() && blocks.by_point.size() > 1;
    field_draws.push_back(by_point ? blocks.by_point.size() : blocks.rows);
  }
  make_unbiased(observations, site, field_draws, field.covariance);
  make_unbiased(observations, site, rows, within.covariance);
  StatisticScatter scatter{field.mean, field.covariance, within.covariance,
                           MatrixXd::Zero(whole.size(), whole.size())};
  if (site.points.size() > 1) {
    const SolidMoments points =
        bootstrap_moments(observations, seen, site, true, [&] { return by_points(site, random); });
    scatter.point_covariance = few_points_factor(site.points.size()) * points.covariance;
  }
  put_stated(observations, whole, scatter);
  return scatter;
}

}  // namespace clast::study_detail

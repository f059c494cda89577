#include "reconstruct/deposit/detail/region_classes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/disjoint_sets.hpp"
#include "core/parallel.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kMinRegionPoints = 80;
constexpr double kMinRelief = 3.0;  ///< in spacings
/// Coefficients of the log odds of a block: self-convexity, ln of the border bend, outer defect, ln
/// of the relief.
constexpr double kConvexityOdds = 24.0, kBendOdds = 2.0, kDefectOdds = 16.0, kReliefOdds = 1.9,
                 kOdds = -11.4;
/// Coefficients of the log odds that the outline is right: log odds of a block (up to a maximum),
/// lowest cost of merging with another region, ln of the number of points, ln of the relief.
/// Fitted to 770 regions of seven virtual deposits, of which 28 were wrong.
constexpr double kClassOdds = 0.371, kMostClassOdds = 12.0, kCostOdds = 7.76, kPointOdds = 1.912,
                 kProbableReliefOdds = -1.741, kProbableOdds = -11.4;
constexpr double kLeastBend = 0.003,
                 kLargestBend = 0.6;  ///< a region without border has the latter
constexpr std::size_t kBorderNeighbours = 8;
constexpr std::size_t kOwnSamples = 80, kOtherSamples = 120;
constexpr double kMeasuringDistance = 3.0;  ///< in spacings
constexpr double kOuterWindow = 1.5;        ///< around a region, in its radii
constexpr double kBorderBand = 2.0;  ///< half width of the borders that are refined, in spacings
constexpr double kLargestPocket = 0.02;  ///< points of enclosed ground over those of the block
constexpr int kVotes = 2;                ///< rounds of majority votes

/// Extent of the samples along the mean of their normals, m.
double extent_along_normals(std::span<const SurfaceSample> samples) {
  Vec3 facing = Vec3::Zero();
  for (const SurfaceSample& s : samples) facing += s.normal;
  if (!(facing.norm() > 0.0)) return 0.0;
  facing.normalize();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const SurfaceSample& s : samples) {
    low = std::min(low, facing.dot(s.position));
    high = std::max(high, facing.dot(s.position));
  }
  return high - low;
}

}  // namespace

double RegionMeasures::block_log_odds() const {
  const double bend = std::clamp(border_bend, kLeastBend, kLargestBend);
  return kConvexityOdds * self_convexity + kBendOdds * std::log(bend) + kDefectOdds * outer_defect +
         kReliefOdds * std::log(std::max(relief, 1.0)) + kOdds;
}

bool RegionMeasures::is_block() const {
  return points >= kMinRegionPoints && relief >= kMinRelief && block_log_odds() > 0.0;
}

double RegionMeasures::block_probability(double lowest_cost) const {
  const double odds = kProbableOdds +
                      kClassOdds * std::clamp(block_log_odds(), 0.0, kMostClassOdds) +
                      kCostOdds * lowest_cost +
                      kPointOdds * std::log(static_cast<double>(std::max<std::size_t>(points, 1))) +
                      kProbableReliefOdds * std::log(std::max(relief, 1.0));
  return 1.0 / (1.0 + std::exp(-odds));
}

std::vector<RegionMeasures> measure_regions(const OrientedPoints& cloud,
                                            const ConvexPatches& patches,
                                            std::span<const SampledPatch> sampled,
                                            std::span<const std::uint32_t> region_of_patch,
                                            unsigned threads) {
  const std::uint32_t count = 1 + *std::max_element(region_of_patch.begin(), region_of_patch.end());
  std::vector<std::vector<std::uint32_t>> members(count);
  for (std::uint32_t p = 0; p < region_of_patch.size(); ++p) {
    members[region_of_patch[p]].push_back(p);
  }
  std::vector<double> bends(count, 0.0), edges(count, 0.0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t own = region_of_patch[patches.patch_of_point[i]];
    for (const std::uint32_t n : cloud.neighbours_of(i).first(kBorderNeighbours)) {
      const std::uint32_t other = region_of_patch[patches.patch_of_point[n]];
      if (other == own) continue;
      for (const std::uint32_t side : {own, other}) {
        bends[side] += 1.0 - cloud.normals[i].dot(cloud.normals[n]);
        edges[side] += 1.0;
      }
    }
  }
  const SampleGrids grids(sampled);
  std::vector<RegionMeasures> measures(count);
  parallel_for(count, threads, [&](std::size_t r) {
    RegionMeasures& m = measures[r];
    Vec3 centre = Vec3::Zero();
    double spacing = 0.0;
    for (const std::uint32_t p : members[r]) {
      m.points += sampled[p].points;
      centre += static_cast<double>(sampled[p].points) * sampled[p].centre;
      spacing += static_cast<double>(sampled[p].points) * sampled[p].spacing;
    }
    if (m.points < kMinRegionPoints) return;
    centre /= static_cast<double>(m.points);
    spacing /= static_cast<double>(m.points);
    double reach = 0.0;
    for (const std::uint32_t p : members[r]) {
      reach = std::max(reach, (sampled[p].centre - centre).norm() + sampled[p].reach);
    }
    const auto region = static_cast<std::uint32_t>(r);
    const std::vector<SurfaceSample> own =
        grids.choose_near(centre, reach, kOwnSamples, region_of_patch, region);
    double sum = 0.0;
    std::size_t pairs = 0;
    for (const SurfaceSample& p : own) {
      for (const SurfaceSample& q : own) {
        const Vec3 offset = q.position - p.position;
        if (offset.norm() < kMeasuringDistance * spacing) continue;
        sum -= p.normal.dot(offset) / offset.norm();
        ++pairs;
      }
    }
    if (pairs > 0) m.self_convexity = sum / static_cast<double>(pairs);
    m.relief = extent_along_normals(own) / spacing;
    const std::vector<SurfaceSample> others = grids.choose_near(
        centre, kOuterWindow * reach, kOtherSamples, region_of_patch, region, SampleOwner::kOthers);
    m.outer_defect = visibility_defect(own, others, kMeasuringDistance * spacing);
    m.border_bend = edges[r] > 0.0 ? bends[r] / edges[r] : kLargestBend;
  });
  return measures;
}

void fill_enclosed_ground(const OrientedPoints& cloud, std::vector<std::uint32_t>& labels) {
  const std::uint32_t count = 1 + *std::max_element(labels.begin(), labels.end());
  std::vector<std::size_t> sizes(count, 0);
  for (const std::uint32_t label : labels) ++sizes[label];
  DisjointSets pockets(cloud.size());
  std::vector<std::uint32_t> enclosing(cloud.size(), 0);  // by the first point of a pocket
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    for (const std::uint32_t n : cloud.neighbours_of(i).first(kBorderNeighbours)) {
      if (labels[i] == 0 && labels[n] == 0) pockets.join(i, n);
    }
  }
  std::vector<std::size_t> pocket_sizes(cloud.size(), 0);
  std::vector<std::uint8_t> has_others(cloud.size(), 0);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (labels[i] == 0) ++pocket_sizes[pockets.find(i)];
    for (const std::uint32_t n : cloud.neighbours_of(i).first(kBorderNeighbours)) {
      if ((labels[i] == 0) == (labels[n] == 0)) continue;
      const std::uint32_t pocket = pockets.find(labels[i] == 0 ? i : n);
      const std::uint32_t block = std::max(labels[i], labels[n]);
      has_others[pocket] |= enclosing[pocket] != 0 && enclosing[pocket] != block;
      enclosing[pocket] = block;
    }
  }
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (labels[i] != 0) continue;
    const std::uint32_t pocket = pockets.find(i);
    const std::uint32_t block = enclosing[pocket];
    if (block == 0 || has_others[pocket]) continue;
    const double share =
        static_cast<double>(pocket_sizes[pocket]) / static_cast<double>(sizes[block]);
    if (share <= kLargestPocket) labels[i] = block;
  }
}

void refine_borders(const OrientedPoints& cloud, std::vector<std::uint32_t>& labels,
                    unsigned threads) {
  const std::size_t count = cloud.size();
  const auto in_chunks = [&](const auto& body) {
    constexpr std::size_t kChunk = 4096;
    parallel_for((count + kChunk - 1) / kChunk, threads, [&](std::size_t chunk) {
      for (std::size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) body(i);
    });
  };
  std::vector<std::uint32_t> next = labels;
  in_chunks([&](std::size_t i) {
    const auto near = cloud.neighbours_of(i);
    const double band = kBorderBand * cloud.spacings[i];
    bool at_border = false;
    for (const std::uint32_t n : near) {
      if (labels[n] == labels[i]) continue;
      at_border |= (cloud.positions[n] - cloud.positions[i]).norm() < band;
    }
    if (!at_border) return;
    std::map<std::uint32_t, std::pair<double, double>> misfit;  // sum of weights and of distances
    for (const std::uint32_t n : near) {
      const Vec3 offset = cloud.positions[i] - cloud.positions[n];
      const double weight = std::max(0.05, cloud.normals[n].dot(cloud.normals[i]));
      auto& [weights, sum] = misfit[labels[n]];
      weights += weight;
      sum += weight * std::abs(cloud.normals[n].dot(offset));
    }
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [label, m] : misfit) {
      // Few neighbours of a region say little about its plane.
      const double mean = (m.second + cloud.spacings[i] * 0.5) / m.first;
      if (mean < best) {
        best = mean;
        next[i] = label;
      }
    }
  });
  labels = next;
  for (int vote = 0; vote < kVotes; ++vote) {
    in_chunks([&](std::size_t i) {
      const auto near =
          cloud.neighbours_of(i).first(std::min<std::size_t>(12, cloud.neighbour_count));
      std::map<std::uint32_t, int> votes;
      ++votes[labels[i]];
      for (const std::uint32_t n : near) ++votes[labels[n]];
      int most = votes[labels[i]];
      next[i] = labels[i];
      for (const auto& [label, number] : votes) {
        if (number > most) {
          most = number;
          next[i] = label;
        }
      }
    });
    labels = next;
  }
}

}  // namespace clast::reconstruct_detail

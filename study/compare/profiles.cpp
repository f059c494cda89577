#include "study/compare/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/nice_number.hpp"
#include "study/compare/path_samples.hpp"

namespace clast {
namespace {

constexpr double kBins = 50.0;
constexpr double kNarrowestBin = 0.5;  ///< m

struct LargestInBin {
  double energy = 0.0;
  double speed = 0.0;
  double height = -INFINITY;
  Vec2 places = Vec2::Zero();  ///< sum, local
  double samples = 0.0;
};
using BinPassage = std::map<int, LargestInBin>;  ///< by number of the bin

double bin_width(const Comparison& comparison) {
  double longest = 0.0;
  for (const RunRow& row : comparison.rows) {
    if (std::isfinite(row.runout)) longest = std::max(longest, std::abs(row.runout));
  }
  return std::max(kNarrowestBin, longest > 0.0 ? round_up_to_nice_number(longest / kBins) : 0.0);
}

/// The passage of every row; empty where a run has no trajectory.
std::vector<BinPassage> bin_passages(const Comparison& comparison, double width) {
  std::vector<BinPassage> all(comparison.rows.size());
  for_each_trajectory(comparison, [&](std::size_t index, const Trajectory& trajectory,
                                      const TerrainSurface& ground) {
    const RunRow& row = comparison.rows[index];
    const Vec2 start = row.record->start.position.head<2>();
    for_each_path_sample(
        trajectory, *row.block, ground, 0.5 * width, [&](const PathSample& sample) {
          const double along = (sample.position.head<2>() - start).dot(comparison.downslope);
          LargestInBin& here = all[index][static_cast<int>(std::floor(along / width))];
          here.energy = std::max(here.energy, sample.energy);
          here.speed = std::max(here.speed, sample.speed);
          if (std::isfinite(sample.height)) here.height = std::max(here.height, sample.height);
          here.places += sample.position.head<2>();
          here.samples += 1.0;
        });
  });
  return all;
}

}  // namespace

std::vector<ProfileBin> compute_profiles(const Comparison& comparison) {
  const double width = bin_width(comparison);
  const std::vector<BinPassage> all = bin_passages(comparison, width);
  std::vector<ProfileBin> bins;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    struct Values {
      std::vector<double> energy, speed, height;
      Vec2 places = Vec2::Zero();
    };
    std::map<int, Values> by_bin;
    for (const std::size_t row : comparison.groups[g].rows) {
      for (const auto& [bin, largest] : all[row]) {
        Values& values = by_bin[bin];
        values.energy.push_back(largest.energy);
        values.speed.push_back(largest.speed);
        if (std::isfinite(largest.height)) values.height.push_back(largest.height);
        values.places += largest.places / largest.samples;
      }
    }
    for (const auto& [bin, values] : by_bin) {
      const double runs = static_cast<double>(values.energy.size());
      // Map frames of all files are the same.
      const Vec2 place = comparison.results.front().frame.origin.head<2>() + values.places / runs;
      bins.push_back({g, bin * width, (bin + 1) * width, values.energy.size(),
                      summarise_sample(values.energy), summarise_sample(values.speed),
                      summarise_sample(values.height), place});
    }
  }
  return bins;
}

const ProfileBin* find_least_energy_bin(const std::vector<ProfileBin>& bins, std::size_t group,
                                        std::size_t started) {
  const ProfileBin *minimum = nullptr, *before = nullptr;
  bool past_peak = false;
  for (const ProfileBin& bin : bins) {
    if (bin.group != group) continue;
    past_peak = past_peak || (before != nullptr && bin.energy.p95 < before->energy.p95);
    before = &bin;
    if (!past_peak || 2 * bin.runs < started) continue;
    if (minimum == nullptr || bin.energy.p95 < minimum->energy.p95) minimum = &bin;
  }
  return minimum;
}

}  // namespace clast

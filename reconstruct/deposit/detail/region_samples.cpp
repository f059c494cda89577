#include "reconstruct/deposit/detail/region_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
#include "core/statistics/statistics.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kSampleCell = 2.5;        ///< side of the cubes, in spacings
constexpr double kDefectTolerance = 0.08;  ///< sine that noise and roughness explain
constexpr double kDefectRange = 0.3;       ///< sine above the tolerance of a full defect

SampledPatch sample_patch(const OrientedPoints& cloud, std::span<const std::uint32_t> points) {
  SampledPatch patch;
  patch.points = points.size();
  for (const std::uint32_t i : points) {
    patch.centre += cloud.positions[i];
    patch.spacing += cloud.spacings[i];
  }
  patch.centre /= static_cast<double>(points.size());
  patch.spacing /= static_cast<double>(points.size());
  const double cell = kSampleCell * patch.spacing;
  using Cube = std::array<long, 3>;
  std::vector<std::pair<Cube, std::uint32_t>> sorted;
  sorted.reserve(points.size());
  for (const std::uint32_t i : points) {
    const Vec3 p = (cloud.positions[i] - patch.centre) / cell;
    sorted.push_back({{std::lround(p.x()), std::lround(p.y()), std::lround(p.z())}, i});
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t first = 0; first < sorted.size();) {
    SurfaceSample sample{Vec3::Zero(), Vec3::Zero()};
    std::size_t last = first;
    for (; last < sorted.size() && sorted[last].first == sorted[first].first; ++last) {
      sample.position += cloud.positions[sorted[last].second];
      sample.normal += cloud.normals[sorted[last].second];
    }
    sample.position /= static_cast<double>(last - first);
    if (!(sample.normal.norm() > 0.0)) sample.normal = cloud.normals[sorted[first].second];
    sample.normal.normalize();
    patch.reach = std::max(patch.reach, (sample.position - patch.centre).norm());
    patch.samples.push_back(sample);
    first = last;
  }
  return patch;
}

}  // namespace

std::vector<SampledPatch> sample_patches(const OrientedPoints& cloud, const ConvexPatches& patches,
                                         unsigned threads) {
  std::vector<std::vector<std::uint32_t>> points(patches.count);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) points[patches.patch_of_point[i]].push_back(i);
  std::vector<SampledPatch> sampled(patches.count);
  parallel_for(patches.count, threads,
               [&](std::size_t p) { sampled[p] = sample_patch(cloud, points[p]); });
  return sampled;
}

namespace {

constexpr double kVoxelsPerCell = 8.0;
constexpr double kVoxelsPerRadius = 12.0;  ///< sparsity of the samples of a query
constexpr double kCellOffset = 1 << 20;    ///< makes the numbers of cells positive

using GridIndex = std::array<std::uint64_t, 3>;

GridIndex index_of(const Vec3& position, double side) {
  GridIndex index;
  for (int k = 0; k < 3; ++k) {
    index[static_cast<std::size_t>(k)] =
        static_cast<std::uint64_t>(std::floor(position[k] / side) + kCellOffset);
  }
  return index;
}

std::uint64_t key_of(const GridIndex& i) { return (i[0] << 42) | (i[1] << 21) | i[2]; }

}  // namespace

SampleGrids::SampleGrids(std::span<const SampledPatch> patches) : patches_(patches) {
  std::vector<double> spacings;
  std::vector<Entry> all;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    spacings.push_back(patches[p].spacing);
    for (std::uint32_t s = 0; s < patches[p].samples.size(); ++s) all.push_back({p, s});
  }
  const auto position = [&](const Entry& e) -> const Vec3& {
    return patches_[e.patch].samples[e.sample].position;
  };
  double voxel = rounded_side(kSampleCell * upper_median(std::move(spacings)));
  while (true) {
    Level level{voxel, {}, {}};
    std::vector<std::pair<std::uint64_t, Entry>> sorted;
    for (const Entry& e : all) {
      sorted.emplace_back(key_of(index_of(position(e), kVoxelsPerCell * voxel)), e);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [key, entry] : sorted) {
      const auto at = static_cast<std::uint32_t>(level.entries.size());
      const auto [cell, is_new] = level.cells.try_emplace(key, at, at);
      level.entries.push_back(entry);
      cell->second.second = at + 1;
    }
    const bool coarsest = level.cells.size() < 100;
    levels_.push_back(std::move(level));
    if (coarsest) return;
    // The first sample of each patch in each voxel of twice the side is kept.
    voxel *= 2.0;
    std::vector<std::pair<std::pair<std::uint32_t, std::uint64_t>, Entry>> by_voxel;
    for (const Entry& e : all) {
      by_voxel.push_back({{e.patch, key_of(index_of(position(e), voxel))}, e});
    }
    std::stable_sort(by_voxel.begin(), by_voxel.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    all.clear();
    for (std::size_t i = 0; i < by_voxel.size(); ++i) {
      if (i == 0 || by_voxel[i].first != by_voxel[i - 1].first) all.push_back(by_voxel[i].second);
    }
  }
}

std::vector<SurfaceSample> SampleGrids::choose_near(const Vec3& centre, double radius,
                                                    std::size_t count,
                                                    std::span<const std::uint32_t> region_of_patch,
                                                    std::uint32_t region, SampleOwner owner) const {
  std::size_t chosen_level = 0;
  while (chosen_level + 1 < levels_.size() &&
         radius > kVoxelsPerRadius * levels_[chosen_level].voxel) {
    ++chosen_level;
  }
  const Level& level = levels_[chosen_level];
  const double side = kVoxelsPerCell * level.voxel;
  const GridIndex low = index_of(centre - Vec3::Constant(radius), side);
  const GridIndex high = index_of(centre + Vec3::Constant(radius), side);
  std::vector<const SurfaceSample*> near;
  for (std::uint64_t x = low[0]; x <= high[0]; ++x) {
    for (std::uint64_t y = low[1]; y <= high[1]; ++y) {
      for (std::uint64_t z = low[2]; z <= high[2]; ++z) {
        const auto cell = level.cells.find(key_of({x, y, z}));
        if (cell == level.cells.end()) continue;
        for (std::uint32_t e = cell->second.first; e < cell->second.second; ++e) {
          const Entry& entry = level.entries[e];
          const bool own = region_of_patch[entry.patch] == region;
          if (own != (owner == SampleOwner::kOwn)) continue;
          const SurfaceSample& sample = patches_[entry.patch].samples[entry.sample];
          if ((sample.position - centre).squaredNorm() <= radius * radius) near.push_back(&sample);
        }
      }
    }
  }
  std::vector<SurfaceSample> chosen;
  const std::size_t total = std::min(count, near.size());
  chosen.reserve(total);
  for (std::size_t k = 0; k < total; ++k) {
    chosen.push_back(*near[(2 * k + 1) * near.size() / (2 * total)]);
  }
  return chosen;
}

double visibility_defect(std::span<const SurfaceSample> a, std::span<const SurfaceSample> b,
                         double min_distance) {
  double sum = 0.0;
  std::size_t pairs = 0;
  for (const SurfaceSample& p : a) {
    for (const SurfaceSample& q : b) {
      const Vec3 offset = q.position - p.position;
      const double distance = offset.norm();
      if (distance < min_distance) continue;
      const double sine = std::max(p.normal.dot(offset), -q.normal.dot(offset)) / distance;
      sum += std::clamp((sine - kDefectTolerance) / kDefectRange, 0.0, 1.0);
      ++pairs;
    }
  }
  return pairs > 0 ? sum / static_cast<double>(pairs) : 0.0;
}

}  // namespace clast::reconstruct_detail

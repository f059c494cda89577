#pragma once
/// Decimated points of patches and regions, and what pairs of them say about convexity.
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "reconstruct/deposit/detail/convex_patches.hpp"
#include "reconstruct/deposit/detail/oriented_points.hpp"

namespace clast::reconstruct_detail {

/// Mean of the points in a small cube, with their mean normal.
struct SurfaceSample {
  Vec3 position;  ///< m
  Vec3 normal;    ///< unit, towards free space
};

/// A patch with few, evenly spread samples.
struct SampledPatch {
  std::vector<SurfaceSample> samples;
  Vec3 centre = Vec3::Zero();  ///< mean of its points
  double reach = 0.0;          ///< largest distance of a sample from the centre, m
  double spacing = 0.0;        ///< mean point spacing, m
  std::size_t points = 0;
};

/// Samples each patch with one sample per cube of 2.5 spacings.
std::vector<SampledPatch> sample_patches(const OrientedPoints& cloud, const ConvexPatches& patches,
                                         unsigned threads);

/// Selection of samples by their region.
enum class SampleOwner { kOwn, kOthers };

/// Samples of all patches, in grids of increasing sparsity, for queries by place and owner.
class SampleGrids {
 public:
  /// @param patches  must outlive the grids
  explicit SampleGrids(std::span<const SampledPatch> patches);

  /// Returns at most `count` samples within `radius` of `centre` that belong to a region, or to all
  /// others. They are evenly chosen in a fixed order.
  /// @param region_of_patch  region of each patch
  std::vector<SurfaceSample> choose_near(const Vec3& centre, double radius, std::size_t count,
                                         std::span<const std::uint32_t> region_of_patch,
                                         std::uint32_t region,
                                         SampleOwner owner = SampleOwner::kOwn) const;

 private:
  struct Entry {
    std::uint32_t patch, sample;
  };
  /// Entries sorted by cell, and where each cell begins.
  struct Level {
    double voxel = 0.0;  ///< distance of samples, m
    std::vector<Entry> entries;
    std::unordered_map<std::uint64_t, std::pair<std::uint32_t, std::uint32_t>> cells;
  };
  std::span<const SampledPatch> patches_;
  std::vector<Level> levels_;
};

/// Mean visibility defect of two sets of samples: 0 if both lie on one convex body, towards 1 if
/// the line between the samples of a pair leaves one of the surfaces on its outer side.
///
/// The defect of a pair is the larger of the sines by which each sample lies above the tangent
/// plane of the other, less a tolerance, over 0.3, limited to [0, 1].
/// @param min_distance  pairs nearer than this are not used, m
/// @returns 0 if there is no pair
double visibility_defect(std::span<const SurfaceSample> a, std::span<const SurfaceSample> b,
                         double min_distance);

}  // namespace clast::reconstruct_detail

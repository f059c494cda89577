#include "reconstruct/deposit/detail/region_merging.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

#include "core/parallel.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kSmallerSamples = 40, kLargerSamples = 60;  ///< of a pair of regions
constexpr double kOwnWindow = 2.0;      ///< radius within which the smaller region is sampled
constexpr double kMergingWindow = 1.5;  ///< radius around the smaller region, in its radii
constexpr double kRadiusOfRms = 1.5;    ///< radius of a region over the rms distance of its points
constexpr double kMergingDistance = 3.0;  ///< in spacings
constexpr double kSeamWeight = 1.5;
constexpr double kContactCost = 1.0;  ///< cost of merging blocks that clearly are two
constexpr double kMaxMergingCost = 0.33;
constexpr std::size_t kSeamNeighbours = 8;  ///< neighbours of a point with which it forms seams

/// Concavities along the border of two regions, and the cost of merging these.
struct Seam {
  std::uint32_t a = 0, b = 0;
  double sum = 0.0, pairs = 0.0;
  double cost = 0.0;
  std::uint32_t version = 0;
  std::uint32_t changes = 0;  ///< sum of the changes of both regions when the cost was computed
  bool ended = false;
};

struct GrowingRegion {
  std::vector<std::uint32_t> patches;
  double points = 0.0;      ///< number of its samples
  Vec3 sum = Vec3::Zero();  ///< of the positions of its samples, and of their squares
  double squares = 0.0;
  std::uint32_t changes = 0;                     ///< number of times that it has grown
  double spacings = 0.0;                         ///< sum of the point spacings at its samples, m
  std::map<std::uint32_t, std::uint32_t> seams;  ///< by the other region

  Vec3 centre() const { return sum / points; }
  double spacing() const { return spacings / points; }
  double radius() const {
    return kRadiusOfRms * std::sqrt(std::max(0.0, squares / points - centre().squaredNorm()));
  }
};

class Merging {
 public:
  Merging(const OrientedPoints& cloud, const ConvexPatches& patches,
          std::span<const SampledPatch> sampled, unsigned threads)
      : sampled_(sampled), grids_(sampled) {
    make_regions();
    make_seams(cloud, patches);
    parallel_for(seams_.size(), threads,
                 [&](std::size_t s) { seams_[s].cost = merging_cost(seams_[s]); });
    for (std::uint32_t s = 0; s < seams_.size(); ++s) push(s);
  }

  MergedRegions run() {
    while (!queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      Seam& seam = seams_[next.seam];
      if (seam.ended || seam.version != next.version) continue;
      if (next.cost > kMaxMergingCost) {
        if (!renew_all()) break;
        continue;
      }
      if (renew(next.seam)) continue;
      merge(next.seam);
    }
    return merged_regions();
  }

 private:
  struct Candidate {
    double cost;
    std::uint32_t seam, version;
    bool operator>(const Candidate& other) const {
      return cost != other.cost ? cost > other.cost : seam > other.seam;
    }
  };

  void make_regions() {
    regions_.resize(sampled_.size());
    owners_.resize(sampled_.size());
    for (std::uint32_t p = 0; p < sampled_.size(); ++p) {
      GrowingRegion& region = regions_[p];
      region.patches = {p};
      owners_[p] = p;
      for (const SurfaceSample& s : sampled_[p].samples) {
        region.sum += s.position;
        region.squares += s.position.squaredNorm();
        region.points += 1.0;
      }
      region.spacings = region.points * sampled_[p].spacing;
    }
  }

  void make_seams(const OrientedPoints& cloud, const ConvexPatches& patches) {
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::uint32_t own = patches.patch_of_point[i];
      for (const std::uint32_t n : cloud.neighbours_of(i).first(kSeamNeighbours)) {
        const std::uint32_t other = patches.patch_of_point[n];
        if (other == own) continue;
        const auto [found, is_new] =
            regions_[own].seams.try_emplace(other, static_cast<std::uint32_t>(seams_.size()));
        if (is_new) {
          regions_[other].seams.emplace(own, found->second);
          seams_.push_back({own, other});
        }
        Seam& seam = seams_[found->second];
        seam.sum += std::max(cloud.concavities[i], cloud.concavities[n]);
        seam.pairs += 1.0;
      }
    }
  }

  double merging_cost(const Seam& seam) const {
    const bool a_smaller = regions_[seam.a].radius() <= regions_[seam.b].radius();
    const GrowingRegion& smaller = regions_[a_smaller ? seam.a : seam.b];
    const GrowingRegion& larger = regions_[a_smaller ? seam.b : seam.a];
    const Vec3 centre = smaller.centre();
    const double radius = smaller.radius();
    const auto near = [&](const GrowingRegion& region, double reach, std::size_t count) {
      return grids_.choose_near(centre, reach * radius, count, owners_, owners_[region.patches[0]]);
    };
    const std::vector<SurfaceSample> own = near(smaller, kOwnWindow, kSmallerSamples);
    const std::vector<SurfaceSample> others = near(larger, kMergingWindow, kLargerSamples);
    const double defect = visibility_defect(
        own, others, kMergingDistance * std::max(smaller.spacing(), larger.spacing()));
    return defect + kSeamWeight * std::max(0.0, seam.sum / seam.pairs);
  }

  std::uint32_t changes_of(const Seam& seam) const {
    return regions_[seam.a].changes + regions_[seam.b].changes;
  }

  void compute(std::uint32_t s) {
    Seam& seam = seams_[s];
    seam.cost = merging_cost(seam);
    seam.changes = changes_of(seam);
    ++seam.version;
  }

  /// Computes the cost of a seam anew if a region has grown since.
  /// @returns whether the seam was put back into the queue, because its cost has risen
  bool renew(std::uint32_t s) {
    if (seams_[s].changes == changes_of(seams_[s])) return false;
    const double before = seams_[s].cost;
    compute(s);
    if (seams_[s].cost <= before) return false;
    push(s);
    return true;
  }

  /// Computes all costs anew that are out of date.
  /// @returns whether one of them is below the limit now
  bool renew_all() {
    bool found = false;
    for (std::uint32_t s = 0; s < seams_.size(); ++s) {
      if (seams_[s].ended || seams_[s].changes == changes_of(seams_[s])) continue;
      compute(s);
      push(s);
      found |= seams_[s].cost <= kMaxMergingCost;
    }
    return found;
  }

  void push(std::uint32_t s) { queue_.push({seams_[s].cost, s, seams_[s].version}); }

  void merge(std::uint32_t joined) {
    seams_[joined].ended = true;
    std::uint32_t kept = seams_[joined].a, gone = seams_[joined].b;
    if (regions_[kept].patches.size() < regions_[gone].patches.size()) std::swap(kept, gone);
    GrowingRegion& region = regions_[kept];
    GrowingRegion absorbed = std::exchange(regions_[gone], {});
    for (const std::uint32_t p : absorbed.patches) owners_[p] = kept;
    region.patches.insert(region.patches.end(), absorbed.patches.begin(), absorbed.patches.end());
    ++region.changes;
    region.sum += absorbed.sum;
    region.squares += absorbed.squares;
    region.points += absorbed.points;
    region.spacings += absorbed.spacings;
    region.seams.erase(gone);
    absorbed.seams.erase(kept);
    std::vector<std::uint32_t> changed;
    for (const auto& [other, s] : absorbed.seams) {
      regions_[other].seams.erase(gone);
      const auto found = region.seams.find(other);
      if (found == region.seams.end()) {
        seams_[s].a = kept;
        seams_[s].b = other;
        region.seams.emplace(other, s);
        regions_[other].seams[kept] = s;
        changed.push_back(s);
      } else {
        Seam& seam = seams_[found->second];
        seam.sum += seams_[s].sum;
        seam.pairs += seams_[s].pairs;
        seams_[s].ended = true;
        changed.push_back(found->second);
      }
    }
    for (const std::uint32_t s : changed) {
      compute(s);
      push(s);
    }
  }

  MergedRegions merged_regions() const {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(regions_.size(), kNone);
    MergedRegions merged;
    std::uint32_t count = 0;
    for (const std::uint32_t r : owners_) {
      if (number[r] == kNone) {
        number[r] = count++;
        double lowest = kContactCost;
        for (const auto& [other, s] : regions_[r].seams) {
          lowest = std::min(lowest, seams_[s].cost);
        }
        merged.lowest_outside.push_back(lowest);
      }
      merged.region_of_patch.push_back(number[r]);
    }
    return merged;
  }

  std::span<const SampledPatch> sampled_;
  SampleGrids grids_;
  std::vector<std::uint32_t> owners_;  ///< region of each patch
  std::vector<GrowingRegion> regions_;
  std::vector<Seam> seams_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

MergedRegions merge_patches(const OrientedPoints& cloud, const ConvexPatches& patches,
                            std::span<const SampledPatch> sampled, unsigned threads) {
  return Merging(cloud, patches, sampled, threads).run();
}

}  // namespace clast::reconstruct_detail

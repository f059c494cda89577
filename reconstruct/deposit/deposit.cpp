#include "reconstruct/deposit/deposit.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/deposit/detail/prior_ellipsoid.hpp"
#include "reconstruct/deposit/detail/region_classes.hpp"
#include "reconstruct/deposit/detail/region_merging.hpp"
#include "reconstruct/deposit/detail/size_uncertainty.hpp"
#include "reconstruct/deposit/detail/star_body.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

using namespace reconstruct_detail;

namespace {

constexpr std::size_t kMinDepositPoints = 100;                  ///< points of a deposit
constexpr std::size_t kMinBlockPoints = 250;                    ///< points of a block
constexpr std::size_t kFitSamples = 250, kAroundSamples = 200;  ///< for the ellipsoid of a block
constexpr double kAroundReach = 1.5;  ///< radius of the surroundings, in the block's largest radii
constexpr double kMinVisibleFraction = 0.12;  ///< of the surface of a block
constexpr std::size_t kContactNeighbours = 12;

/// Returns at most `count` evenly chosen entries.
template <class Entry>
std::vector<Entry> choose_evenly(std::span<const Entry> entries, std::size_t count) {
  std::vector<Entry> chosen;
  const std::size_t total = std::min(count, entries.size());
  for (std::size_t k = 0; k < total; ++k) {
    chosen.push_back(entries[(2 * k + 1) * entries.size() / (2 * total)]);
  }
  return chosen;
}

/// Region of each point: 0 for ground and fines, 1, 2, ... for blocks.
std::vector<std::uint32_t> label_points(const OrientedPoints& cloud, unsigned threads) {
  const ConvexPatches patches = find_convex_patches(cloud);
  const std::vector<SampledPatch> sampled = sample_patches(cloud, patches, threads);
  const std::vector<std::uint32_t> region = merge_patches(cloud, patches, sampled, threads);
  const std::vector<RegionMeasures> measures =
      measure_regions(cloud, patches, sampled, region, threads);
  std::vector<std::uint32_t> number(measures.size(), 0);
  std::uint32_t blocks = 0;
  for (std::size_t r = 0; r < measures.size(); ++r) {
    if (measures[r].is_block()) number[r] = ++blocks;
  }
  std::vector<std::uint32_t> labels(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    labels[i] = number[region[patches.patch_of_point[i]]];
  }
  refine_borders(cloud, labels, threads);
  return labels;
}

/// Blocks whose points are beside those of each block, by label.
std::vector<std::set<std::uint32_t>> find_contacts(const OrientedPoints& cloud,
                                                   std::span<const std::uint32_t> labels,
                                                   std::size_t count) {
  std::vector<std::set<std::uint32_t>> contacts(count);
  const std::size_t degree = std::min(kContactNeighbours, cloud.neighbour_count);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (const std::uint32_t n : cloud.neighbours_of(i).first(degree)) {
      if (labels[n] == labels[i] || labels[n] == 0 || labels[i] == 0) continue;
      contacts[labels[i]].insert(labels[n]);
      contacts[labels[n]].insert(labels[i]);
    }
  }
  return contacts;
}

/// Estimates the body of a block from its points and those around it.
void estimate_body(DepositBlock& block, const OrientedPoints& cloud, const SampledPatch& seen,
                   std::span<const SurfaceSample> others) {
  std::vector<SurfaceSample> around;
  for (const SurfaceSample& s : others) {
    if ((s.position - seen.centre).norm() < kAroundReach * seen.reach) around.push_back(s);
  }
  const Ellipsoid ellipsoid =
      fit_prior_ellipsoid(choose_evenly<SurfaceSample>(seen.samples, kFitSamples),
                          choose_evenly<SurfaceSample>(around, kAroundSamples));
  std::vector<SurfaceSample> points;
  for (const std::uint32_t i : block.points) {
    points.push_back({cloud.positions[i], cloud.normals[i]});
  }
  StarBody body = fit_star_body(points, ellipsoid, seen.spacing);
  for (Vec3& v : body.mesh.vertices) {
    v += cloud.origin;
    block.centre += v / static_cast<double>(body.mesh.vertices.size());
  }
  block.body = std::move(body.mesh);
  block.is_observed = std::move(body.is_vertex_observed);
  block.spacing = seen.spacing;
  block.visible_fraction = body.visible_fraction;
  block.bounds = estimate_size_uncertainty(
      signed_volume(block.body), smallest_box(block.body.vertices).lengths, block.visible_fraction);
}

bool precedes_in_plan(const Vec3& a, const Vec3& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

}  // namespace

void DepositOptions::check() const {
  if (!(smallest_axis >= 0.0 && smallest_axis < 1e3)) {
    throw InputError("smallest_axis = " + format_significant(smallest_axis, 4) +
                     ": must be a length from 0 to 1000 m");
  }
}

Deposit segment_deposit(std::span<const Vec3> points, const DepositOptions& options) {
  options.check();
  if (points.size() < kMinDepositPoints) {
    throw GeometryError(std::to_string(points.size()) +
                        " points are too few for a deposit; at least " +
                        std::to_string(kMinDepositPoints) + " are needed");
  }
  const OrientedPoints cloud = orient_points(points, options.up, options.threads);
  ConvexPatches parts{label_points(cloud, options.threads), 1};
  for (const std::uint32_t label : parts.patch_of_point) {
    parts.count = std::max<std::size_t>(parts.count, label + 1);
  }
  const std::vector<SampledPatch> sampled = sample_patches(cloud, parts, options.threads);
  const std::vector<std::set<std::uint32_t>> contacts =
      find_contacts(cloud, parts.patch_of_point, parts.count);
  std::vector<DepositBlock> blocks(parts.count);
  Deposit deposit;
  deposit.spacing = cloud.spacing;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t label = parts.patch_of_point[i];
    (label == 0 ? deposit.ground : blocks[label].points).push_back(i);
  }
  parallel_for(parts.count, options.threads, [&](std::size_t label) {
    if (label == 0 || blocks[label].points.size() < kMinBlockPoints) return;
    std::vector<SurfaceSample> others;
    for (std::size_t other = 0; other < parts.count; ++other) {
      if (other == label) continue;
      const SampledPatch& patch = sampled[other];
      if ((patch.centre - sampled[label].centre).norm() >
          patch.reach + kAroundReach * sampled[label].reach) {
        continue;
      }
      others.insert(others.end(), patch.samples.begin(), patch.samples.end());
    }
    estimate_body(blocks[label], cloud, sampled[label], others);
  });

  std::vector<std::uint32_t> kept;
  for (std::uint32_t label = 1; label < parts.count; ++label) {
    const DepositBlock& block = blocks[label];
    if (block.points.empty()) continue;
    const Vec3 place = cloud.origin + sampled[label].centre;
    if (block.points.size() < kMinBlockPoints) {
      deposit.left_out.push_back({LeftOutReason::kTooFewPoints, place, block.points.size()});
    } else if (smallest_box(block.body.vertices).lengths[1] < options.smallest_axis) {
      deposit.left_out.push_back({LeftOutReason::kTooSmall, place, block.points.size()});
    } else if (block.visible_fraction < kMinVisibleFraction) {
      deposit.left_out.push_back({LeftOutReason::kMostlyHidden, place, block.points.size()});
    } else {
      kept.push_back(label);
    }
  }
  std::sort(kept.begin(), kept.end(), [&](std::uint32_t a, std::uint32_t b) {
    return precedes_in_plan(blocks[a].centre, blocks[b].centre);
  });
  std::sort(deposit.left_out.begin(), deposit.left_out.end(),
            [](const LeftOutPart& a, const LeftOutPart& b) {
              return precedes_in_plan(a.centre, b.centre);
            });
  std::vector<std::uint32_t> number(parts.count, std::numeric_limits<std::uint32_t>::max());
  for (std::uint32_t k = 0; k < kept.size(); ++k) number[kept[k]] = k;
  for (const std::uint32_t label : kept) {
    for (const std::uint32_t other : contacts[label]) {
      if (number[other] < kept.size()) blocks[label].contacts.push_back(number[other]);
    }
    std::sort(blocks[label].contacts.begin(), blocks[label].contacts.end());
    deposit.blocks.push_back(std::move(blocks[label]));
  }
  return deposit;
}

}  // namespace clast

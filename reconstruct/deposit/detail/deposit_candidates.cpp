#include "reconstruct/deposit/detail/deposit_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "core/parallel.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/deposit/detail/prior_ellipsoid.hpp"
#include "reconstruct/deposit/detail/region_classes.hpp"
#include "reconstruct/deposit/detail/region_merging.hpp"
#include "reconstruct/deposit/detail/size_uncertainty.hpp"
#include "reconstruct/deposit/detail/star_body.hpp"
#include "reconstruct/deposit/detail/station_views.hpp"
#include "shapes/oriented_box.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kMinBlockPoints = 100;  ///< points of a block
constexpr double kMinConfidence = 0.25;
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

/// Points with the blocks that they belong to.
struct LabelledPoints {
  std::vector<std::uint32_t> labels;  ///< block of each point, from 1; 0: ground and fines
  std::vector<double> confidences;    ///< confidence of each label
};

LabelledPoints label_points(const OrientedPoints& cloud, unsigned threads) {
  const ConvexPatches patches = find_convex_patches(cloud);
  const std::vector<SampledPatch> sampled = sample_patches(cloud, patches, threads);
  const MergedRegions merged = merge_patches(cloud, patches, sampled, threads);
  const std::vector<std::uint32_t>& region = merged.region_of_patch;
  const std::vector<RegionMeasures> measures =
      measure_regions(cloud, patches, sampled, region, threads);
  std::vector<std::uint32_t> number(measures.size(), 0);
  LabelledPoints labelled{{}, {0.0}};
  for (std::size_t r = 0; r < measures.size(); ++r) {
    if (!measures[r].is_block()) continue;
    number[r] = static_cast<std::uint32_t>(labelled.confidences.size());
    labelled.confidences.push_back(measures[r].block_probability(merged.lowest_outside[r]));
  }
  labelled.labels.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    labelled.labels[i] = number[region[patches.patch_of_point[i]]];
  }
  refine_borders(cloud, labelled.labels, threads);
  fill_enclosed_ground(cloud, labelled.labels);
  return labelled;
}

/// For each label, one point of every other block whose points are beside its own.
std::vector<std::vector<std::uint32_t>> find_contact_points(const OrientedPoints& cloud,
                                                            std::span<const std::uint32_t> labels,
                                                            std::size_t count) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> contacts(count);
  const std::size_t degree = std::min(kContactNeighbours, cloud.neighbour_count);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    for (const std::uint32_t n : cloud.neighbours_of(i).first(degree)) {
      if (labels[n] == labels[i] || labels[n] == 0 || labels[i] == 0) continue;
      contacts[labels[i]].emplace(labels[n], n);
      contacts[labels[n]].emplace(labels[i], i);
    }
  }
  std::vector<std::vector<std::uint32_t>> points(count);
  for (std::size_t label = 0; label < count; ++label) {
    for (const auto& [other, point] : contacts[label]) points[label].push_back(point);
  }
  return points;
}

/// Estimates the body of a block from its points and those around it.
void estimate_body(DepositBlock& block, std::span<const SurfaceSample> points, const Vec3& origin,
                   const SampledPatch& seen, std::span<const SurfaceSample> others,
                   const StationViews& views) {
  std::vector<SurfaceSample> around;
  for (const SurfaceSample& s : others) {
    if ((s.position - seen.centre).norm() < kAroundReach * seen.reach) around.push_back(s);
  }
  const Ellipsoid ellipsoid =
      fit_prior_ellipsoid(choose_evenly<SurfaceSample>(seen.samples, kFitSamples),
                          choose_evenly<SurfaceSample>(around, kAroundSamples));
  std::function<bool(const Vec3&)> is_free;
  if (!views.is_empty()) {
    is_free = [&](const Vec3& position) { return views.is_free(position, seen.spacing); };
  }
  StarBody body = fit_star_body(points, ellipsoid, seen.spacing, is_free);
  for (Vec3& v : body.mesh.vertices) {
    v += origin;
    block.centre += v / static_cast<double>(body.mesh.vertices.size());
  }
  block.body = std::move(body.mesh);
  block.is_observed = std::move(body.is_vertex_observed);
  block.spacing = seen.spacing;
  block.visible_fraction = body.visible_fraction;
  block.sides = smallest_box(block.body.vertices).lengths;
  block.bounds =
      estimate_size_uncertainty(signed_volume(block.body), block.sides, block.visible_fraction);
}

/// Reason to leave out a block with enough points, whose body has been estimated.
std::optional<LeftOutReason> find_reason(const DepositBlock& block, const DepositOptions& options) {
  if (block.sides[1] < options.smallest_axis) return LeftOutReason::kTooSmall;
  if (block.visible_fraction < kMinVisibleFraction) return LeftOutReason::kMostlyHidden;
  return {};
}

}  // namespace

DepositCandidates find_candidates(std::span<const Vec3> points, const PlanBox& core,
                                  const ScanExtent& scan, const DepositOptions& options) {
  const auto begin_step = [&](const char* what) {
    if (options.progress) options.progress({.activity = what});
  };
  begin_step("orienting points");
  const OrientedPoints cloud = orient_points(points, scan.middle(), options.threads);
  begin_step("segmenting points");
  LabelledPoints labelled = label_points(cloud, options.threads);
  EditedLabels edited =
      apply_deposit_edits(std::move(labelled.labels), points, cloud.spacing, options.edits);
  // The edits of a whole scan are checked before its bodies are estimated.
  if (core.is_unbounded()) check_edits_fit(options.edits, edited.misfits);
  const ConvexPatches parts{std::move(edited.labels), edited.sources.size()};
  const std::vector<SampledPatch> sampled = sample_patches(cloud, parts, options.threads);
  const std::vector<std::vector<std::uint32_t>> contact_points =
      find_contact_points(cloud, parts.patch_of_point, parts.count);
  begin_step("estimating bodies");
  std::vector<Vec3> stations;
  for (const Vec3& station : options.stations) stations.push_back(station - cloud.origin);
  const StationViews views(cloud, stations);
  std::vector<std::vector<std::uint32_t>> members(parts.count);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) members[parts.patch_of_point[i]].push_back(i);

  DepositCandidates found;
  found.spacing = cloud.spacing;
  std::vector<std::size_t> label_of_candidate;
  for (std::size_t label = 1; label < parts.count; ++label) {
    const Vec3 centre = cloud.origin + sampled[label].centre;
    if (members[label].empty() || !core.contains(centre)) continue;
    DepositCandidate candidate;
    candidate.block.points = std::move(members[label]);
    candidate.block.confidence =
        edited.accepted_by[label] > 0 ? 1.0 : labelled.confidences[edited.sources[label]];
    candidate.centre = centre;
    candidate.contact_points = contact_points[label];
    found.candidates.push_back(std::move(candidate));
    label_of_candidate.push_back(label);
  }
  parallel_for(found.candidates.size(), options.threads, [&](std::size_t c) {
    DepositCandidate& candidate = found.candidates[c];
    const std::size_t label = label_of_candidate[c];
    if (candidate.block.points.size() < kMinBlockPoints) {
      candidate.left_out = LeftOutReason::kTooFewPoints;
      return;
    }
    if (candidate.block.confidence < kMinConfidence) {
      candidate.left_out = LeftOutReason::kUncertain;
      return;
    }
    std::vector<SurfaceSample> own;
    for (const std::uint32_t i : candidate.block.points) {
      own.push_back({cloud.origin + cloud.positions[i], cloud.normals[i]});
    }
    if (scan.border_cuts(own, sampled[label].spacing)) {
      candidate.left_out = LeftOutReason::kCutByBorder;
      return;
    }
    for (SurfaceSample& s : own) s.position -= cloud.origin;
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
    estimate_body(candidate.block, own, cloud.origin, sampled[label], others, views);
    candidate.left_out = find_reason(candidate.block, options);
  });
  found.misfits = std::move(edited.misfits);
  for (std::size_t c = 0; c < found.candidates.size(); ++c) {
    const std::size_t number = edited.accepted_by[label_of_candidate[c]];
    if (number == 0 || !found.candidates[c].left_out) continue;
    found.misfits[number] =
        "the block is left out (" + name_of(*found.candidates[c].left_out) + "); remove the edit";
  }
  return found;
}

}  // namespace clast::reconstruct_detail

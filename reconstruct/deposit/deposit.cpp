#include "reconstruct/deposit/deposit.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "reconstruct/deposit/detail/deposit_candidates.hpp"
#include "reconstruct/deposit/detail/plan_tiles.hpp"

namespace clast {

using namespace reconstruct_detail;

namespace {

constexpr std::size_t kMinDepositPoints = 100;  ///< points of a deposit
constexpr double kTileOverlap = 0.1;    ///< width of the overlap of tiles at first, in tile sides
constexpr double kLeastOverlap = 50.0;  ///< in spacings
constexpr int kOverlapDoublings = 3;    ///< at most
constexpr double kTileBorder = 6.0;     ///< width of the border of a tile, in spacings
constexpr std::uint32_t kNoBlock = std::numeric_limits<std::uint32_t>::max();

bool precedes_in_plan(const Vec3& a, const Vec3& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

/// Longer side in plan of the bounding box of the points in a box, m.
double extent_in_plan(std::span<const Vec3> points, const PlanBox& box) {
  Bounds extent;
  for (const Vec3& p : points) {
    if (box.contains(p)) extent.include(p);
  }
  return (extent.high - extent.low).head<2>().maxCoeff();
}

/// Finds the candidates whose centres are in a tile, with indices of `points`. If one of them
/// reaches the border of what is segmented, the overlap with the other tiles is doubled.
DepositCandidates find_tile_candidates(std::span<const Vec3> points, const PlanBox& tile,
                                       const ScanExtent& scan, const DepositOptions& options) {
  double overlap = kTileOverlap * extent_in_plan(points, tile);
  for (int doublings = 0;; ++doublings, overlap *= 2.0) {
    const PlanBox extent = tile.expanded(overlap);
    const std::vector<std::uint32_t> members = find_points_within(points, extent);
    if (members.size() < kMinDepositPoints) return {};
    std::vector<Vec3> part;
    for (const std::uint32_t i : members) part.push_back(points[i]);
    DepositCandidates found = find_candidates(part, tile, scan, options);
    const PlanBox inside = extent.expanded(-kTileBorder * found.spacing);
    bool is_cut = overlap < kLeastOverlap * found.spacing;
    for (DepositCandidate& candidate : found.candidates) {
      for (std::uint32_t& i : candidate.block.points) {
        is_cut |= !inside.contains(part[i]);
        i = members[i];
      }
      for (std::uint32_t& i : candidate.contact_points) i = members[i];
    }
    if (!is_cut || doublings == kOverlapDoublings) return found;
  }
}

/// Finds the candidates of a cloud, tile by tile. A point belongs to one candidate at most.
DepositCandidates find_all_candidates(std::span<const Vec3> points, const DepositOptions& options) {
  const std::vector<PlanBox> tiles = divide_in_plan(points, options.tile_points);
  const ScanExtent scan(points);
  if (tiles.size() == 1) return find_candidates(points, tiles.front(), scan, options);
  DepositCandidates all;
  std::set<std::size_t> fitting;  // edits that fit some tile
  std::vector<bool> is_taken(points.size(), false);
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    DepositOptions one = options;
    if (options.progress) {
      one.progress = [&, t](const ProgressUpdate& step) {
        options.progress({.activity = step.activity + ", tile " + std::to_string(t + 1) + " of " +
                                      std::to_string(tiles.size())});
      };
    }
    DepositCandidates found = find_tile_candidates(points, tiles[t], scan, one);
    all.spacing += found.spacing / static_cast<double>(tiles.size());
    for (std::size_t number = 1; number <= options.edits.size() && found.spacing > 0.0; ++number) {
      if (!found.misfits.contains(number)) fitting.insert(number);
    }
    all.misfits.merge(found.misfits);
    for (DepositCandidate& candidate : found.candidates) {
      std::vector<std::uint32_t>& own = candidate.block.points;
      const std::size_t before = own.size();
      std::erase_if(own, [&](std::uint32_t i) { return is_taken[i]; });
      if (2 * own.size() < before) continue;  // found in another tile too
      for (const std::uint32_t i : own) is_taken[i] = true;
      all.candidates.push_back(std::move(candidate));
    }
  }
  for (const std::size_t number : fitting) all.misfits.erase(number);
  return all;
}

/// Point of a candidate that is nearest to the mean of its points.
const Vec3& find_middle_point(std::span<const Vec3> points, const DepositCandidate& candidate) {
  const std::vector<std::uint32_t>& own = candidate.block.points;
  return points[*std::min_element(own.begin(), own.end(), [&](std::uint32_t a, std::uint32_t b) {
    return (points[a] - candidate.centre).squaredNorm() <
           (points[b] - candidate.centre).squaredNorm();
  })];
}

/// Adds to each block the numbers of the blocks to which its contact points belong.
void add_contacts(std::vector<DepositBlock>& blocks,
                  const std::vector<std::vector<std::uint32_t>>& contact_points,
                  std::size_t points) {
  std::vector<std::uint32_t> block_of_point(points, kNoBlock);
  for (std::uint32_t b = 0; b < blocks.size(); ++b) {
    for (const std::uint32_t i : blocks[b].points) block_of_point[i] = b;
  }
  for (std::uint32_t b = 0; b < blocks.size(); ++b) {
    for (const std::uint32_t i : contact_points[b]) {
      const std::uint32_t other = block_of_point[i];
      if (other == kNoBlock || other == b) continue;
      blocks[b].contacts.push_back(other);
      blocks[other].contacts.push_back(b);
    }
  }
  for (DepositBlock& block : blocks) {
    std::sort(block.contacts.begin(), block.contacts.end());
    block.contacts.erase(std::unique(block.contacts.begin(), block.contacts.end()),
                         block.contacts.end());
  }
}

}  // namespace

std::string name_of(LeftOutReason reason) {
  switch (reason) {
    case LeftOutReason::kTooFewPoints:
      return "too few points";
    case LeftOutReason::kTooSmall:
      return "axis I less than `smallest_axis`";
    case LeftOutReason::kMostlyHidden:
      return "too little of the surface visible";
    case LeftOutReason::kCutByBorder:
      return "cut by the border of the scan";
    case LeftOutReason::kUncertain:
      return "uncertain outline";
  }
  return "";
}

void DepositOptions::check() const {
  if (!(smallest_axis >= 0.0 && smallest_axis < 1e3)) {
    throw InputError("smallest_axis = " + format_significant(smallest_axis, 4) +
                     ": must be a length from 0 to 1000 m");
  }
}

Deposit segment_deposit(std::span<const Vec3> points, const DepositOptions& options) {
  options.check();
  if (points.size() < kMinDepositPoints) {
    throw GeometryError(
        format_count(points.size(), "point") + (points.size() == 1 ? " is" : " are") +
        " too few for a deposit; at least " + std::to_string(kMinDepositPoints) + " are needed");
  }
  DepositCandidates all = find_all_candidates(points, options);
  check_edits_fit(options.edits, all.misfits);
  Deposit deposit;
  deposit.spacing = all.spacing;
  std::vector<bool> is_ground(points.size(), true);
  std::vector<DepositCandidate*> kept;
  for (DepositCandidate& candidate : all.candidates) {
    for (const std::uint32_t i : candidate.block.points) is_ground[i] = false;
    if (candidate.left_out) {
      deposit.left_out.push_back({*candidate.left_out, find_middle_point(points, candidate),
                                  candidate.block.points.size()});
    } else {
      kept.push_back(&candidate);
    }
  }
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (is_ground[i]) deposit.ground.push_back(i);
  }
  std::sort(kept.begin(), kept.end(), [](const DepositCandidate* a, const DepositCandidate* b) {
    return precedes_in_plan(a->block.centre, b->block.centre);
  });
  std::sort(deposit.left_out.begin(), deposit.left_out.end(),
            [](const LeftOutPart& a, const LeftOutPart& b) {
              return precedes_in_plan(a.centre, b.centre);
            });
  std::vector<std::vector<std::uint32_t>> contact_points;
  for (DepositCandidate* candidate : kept) {
    deposit.blocks.push_back(std::move(candidate->block));
    contact_points.push_back(std::move(candidate->contact_points));
  }
  add_contacts(deposit.blocks, contact_points, points.size());
  return deposit;
}

}  // namespace clast

#include "library/deposit_observations.hpp"

#include <map>
#include <string>

#include "mesh/plan_cover.hpp"

namespace clast {
namespace {

Axes axes_of(const Vec3& sides) { return {sides[0], sides[1], sides[2]}; }

DepositObservation observation_of(const Block& block, const PlanCover& cover) {
  const SizeIntervals& intervals = *block.volume_bracket->intervals;
  DepositObservation seen;
  seen.lower_axes = axes_of(intervals.sides.lower);
  seen.upper_axes = axes_of(intervals.sides.upper);
  seen.volume = block.mass.volume;
  seen.lower_volume = intervals.lower_volume;
  seen.upper_volume = intervals.upper_volume;
  seen.long_axis = block.box.axes.col(0);
  seen.points = block.deposit->points;
  seen.spacing = block.deposit->spacing;
  seen.visible_fraction = block.deposit->visible_fraction;
  seen.confidence = block.deposit->confidence;
  seen.plan_area = cover.area;
  seen.exposed_area = cover.exposed;
  return seen;
}

}  // namespace

std::vector<std::optional<DepositObservation>> make_deposit_observations(
    std::span<const Block> blocks) {
  std::map<std::string, std::vector<std::size_t>> scans;  // by the digest of their file
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    if (!block.deposit || !block.volume_bracket || !block.volume_bracket->intervals) continue;
    scans[block.source.sha256].push_back(i);
  }
  std::vector<std::optional<DepositObservation>> observations(blocks.size());
  for (const auto& [digest, members] : scans) {
    std::vector<const TriangleMesh*> bodies;
    for (const std::size_t i : members) bodies.push_back(&blocks[i].surface);
    const std::vector<PlanCover> covers = measure_plan_cover(bodies);
    for (std::size_t k = 0; k < members.size(); ++k) {
      observations[members[k]] = observation_of(blocks[members[k]], covers[k]);
    }
  }
  return observations;
}

}  // namespace clast

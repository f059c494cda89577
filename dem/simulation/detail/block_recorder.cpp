#include "dem/simulation/detail/block_recorder.hpp"

#include <algorithm>

namespace clast::dem_detail {

namespace {

/// Returns the length of the path of the centre, m.
double way_of(const MotionStep& step) {
  if (!step.flight) return (step.end.position - step.begin.position).norm();
  // Length of a parabola, by Simpson's rule over the speed.
  const double middle = 0.5 * (step.begin.velocity + step.end.velocity).norm();
  return (step.end_time - step.begin_time) / 6.0 *
         (step.begin.velocity.norm() + 4.0 * middle + step.end.velocity.norm());
}

}  // namespace

void BlockRecorder::record_step(const MotionStep& step) {
  ReleaseResult& release = result.release;
  if (step.flight) ++release.flight_segments;
  release.path_length += way_of(step);
  release.max_speed =
      std::max({release.max_speed, step.begin.velocity.norm(), step.end.velocity.norm()});
  release.max_penetration = std::max(release.max_penetration, step.contact_summary.overlap);
  const bool was_touching = touching;
  touching = step.contact_summary.contact_count > 0;
  if (touching) ++release.contact_steps;
  if (touching && !was_touching) ++release.impacts;
}

void BlockRecorder::record_hits(std::span<const std::size_t> others) {
  for (const std::size_t other : others) {
    const auto position = std::lower_bound(hit_blocks.begin(), hit_blocks.end(), other);
    if (position == hit_blocks.end() || *position != other) hit_blocks.insert(position, other);
  }
}

}  // namespace clast::dem_detail

#include "dem/simulation/detail/release_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clast::dem_detail {

bool ReleaseSchedule::is_confined(std::size_t block) const {
  return std::any_of(settings_.confining_walls.begin(), settings_.confining_walls.end(),
                     [&](const ConfiningWall& f) { return block >= f.first && block < f.end; });
}

bool ReleaseSchedule::starts_fixed(std::size_t block) const {
  // While confined blocks settle, no other block moves.
  return settings_.at_once && !is_confined(block) &&
         (blocks_[block].release_time > 0.0 || !settings_.confining_walls.empty());
}

double ReleaseSchedule::release_time(std::size_t block) const {
  double time = std::numeric_limits<double>::infinity();
  for (const ConfiningWall& wall : settings_.confining_walls) {
    if (block >= wall.first && block < wall.end) time = std::min(time, wall.removed_at);
  }
  return std::isfinite(time) ? time : blocks_[block].release_time;
}

}  // namespace clast::dem_detail

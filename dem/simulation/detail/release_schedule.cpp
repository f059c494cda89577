#include "dem/simulation/detail/release_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clast::dem_detail {

bool ReleaseSchedule::settles(std::size_t block) const {
  return std::any_of(settings_.forms.begin(), settings_.forms.end(),
                     [&](const SequenceForm& f) { return block >= f.first && block < f.end; });
}

bool ReleaseSchedule::is_held(std::size_t block) const {
  // While others settle, nothing else moves.
  return settings_.at_once && !settles(block) &&
         (blocks_[block].held > 0.0 || !settings_.forms.empty());
}

double ReleaseSchedule::release_time(std::size_t block) const {
  double time = std::numeric_limits<double>::infinity();
  for (const SequenceForm& form : settings_.forms) {
    if (block >= form.first && block < form.end) time = std::min(time, form.removed_at);
  }
  return std::isfinite(time) ? time : blocks_[block].held;
}

}  // namespace clast::dem_detail

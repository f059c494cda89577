#include "study/impact.hpp"

#include <algorithm>

namespace clast {

void ImpactObserver::begin_impact(const MotionStep& step) {
  open_ = Impact{};
  open_->run = run_;
  open_->zone = step.touch.zone;
  open_->time = step.end_time;
  open_->place = step.touch.place;
  open_->speed_before = step.end.velocity.norm();
  open_->translational_before = translational_energy(body_, step.end);
  open_->rotational_before = rotational_energy(body_, step.end);
  leave(step.end, step.end_time);
}

void ImpactObserver::leave(const RigidState& state, double time) {
  open_->contact_duration = time - open_->time;
  open_->speed_after = state.velocity.norm();
  open_->translational_after = translational_energy(body_, state);
  open_->rotational_after = rotational_energy(body_, state);
}

void ImpactObserver::see(const MotionStep& step) {
  const double duration = step.end_time - step.begin_time;
  if (step.flight) {
    if (!take_off_) take_off_ = step.begin.position.head<2>();
    flight_ += duration;
    statistics.longest_flight =
        std::max(statistics.longest_flight, (step.end.position.head<2>() - *take_off_).norm());
    if (open_ && flight_ >= kShortestFlight) {
      impacts.push_back(*open_);
      open_.reset();
    }
  } else {
    take_off_.reset();
    statistics.contact_time += duration;
    statistics.mean_points += duration * step.touch.points;  // divided at the end
  }
  if (step.touch.points > 0) {
    // A run that starts in contact has no impact before its first flight.
    if (!open_ && step.flight) begin_impact(step);
    if (open_) {
      open_->depth = std::max(open_->depth, step.touch.overlap);
      leave(step.end, step.end_time);
    }
    flight_ = 0.0;
  } else if (!step.flight && open_) {
    leave(step.end, step.end_time);
  }
  statistics.most_points = std::max<std::uint64_t>(statistics.most_points, step.touch.points);
  for (const RigidState& state : {step.begin, step.end}) {
    statistics.max_energy = std::max(statistics.max_energy, translational_energy(body_, state) +
                                                                rotational_energy(body_, state));
    statistics.max_spin = std::max(statistics.max_spin, state.angular_velocity.norm());
  }
}

void ImpactObserver::finish() {
  if (open_) impacts.push_back(*open_);
  open_.reset();
  if (statistics.contact_time > 0.0) statistics.mean_points /= statistics.contact_time;
}

}  // namespace clast

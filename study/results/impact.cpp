#include "study/results/impact.hpp"

#include <algorithm>
#include <cmath>

namespace clast {

void ImpactObserver::begin_impact(const MotionStep& step) {
  open_ = Impact{};
  open_->run = run_;
  open_->zone = step.contact_summary.zone;
  open_->time = step.end_time;
  open_->position = step.contact_summary.position;
  open_->speed_before = step.end.velocity.norm();
  open_->translational_before = translational_energy(body_, step.end);
  open_->rotational_before = rotational_energy(body_, step.end);
}

void ImpactObserver::end_impact() {
  open_->contact_duration = last_touch_time_ - open_->time;
  open_->speed_after = last_touch_.velocity.norm();
  open_->translational_after = translational_energy(body_, last_touch_);
  open_->rotational_after = rotational_energy(body_, last_touch_);
  impacts.push_back(*open_);
  last_contact_states.push_back(last_touch_);
  open_.reset();
}

// Called at every time step: what costs is done only where it can change something.
void ImpactObserver::update_maxima(const RigidState& state) {
  const double spin = state.angular_velocity.squaredNorm();
  const double bound =
      0.5 * (body_.mass * state.velocity.squaredNorm() + body_.moments.maxCoeff() * spin);
  if (bound > statistics.max_energy) {
    statistics.max_energy = std::max(statistics.max_energy, translational_energy(body_, state) +
                                                                rotational_energy(body_, state));
  }
  statistics.max_spin = std::max(statistics.max_spin, std::sqrt(spin));
}

void ImpactObserver::observe_step(const MotionStep& step) {
  const double duration = step.end_time - step.begin_time;
  if (first_) update_maxima(step.begin);
  first_ = false;
  if (!step.correction_pending) update_maxima(step.end);
  statistics.max_contact_points =
      std::max<std::uint64_t>(statistics.max_contact_points, step.contact_summary.contact_count);
  if (step.flight) {
    if (!take_off_) take_off_ = step.begin.position.head<2>();
    flight_ += duration;
    statistics.longest_flight =
        std::max(statistics.longest_flight, (step.end.position.head<2>() - *take_off_).norm());
    if (open_ && flight_ >= kMinFlight) end_impact();
    // A run that starts in contact has no impact before its first flight.
    if (!open_ && step.contact_summary.contact_count > 0) begin_impact(step);
  } else {
    take_off_.reset();
    statistics.contact_time += duration;
    statistics.mean_contact_points +=
        duration * step.contact_summary.contact_count;  // divided at the end
  }
  if (open_ && (step.contact_summary.contact_count > 0 || !step.flight)) {
    open_->depth = std::max(open_->depth, step.contact_summary.overlap);
    last_touch_ = step.end;
    last_touch_time_ = step.end_time;
  }
  if (step.contact_summary.contact_count > 0) flight_ = 0.0;
}

void ImpactObserver::finish() {
  if (open_) end_impact();
  if (statistics.contact_time > 0.0) statistics.mean_contact_points /= statistics.contact_time;
}

}  // namespace clast

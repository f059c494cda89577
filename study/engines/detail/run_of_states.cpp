#include "study/engines/detail/run_of_states.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clast::study_detail {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
/// A flight leads from one state to the next within these, m and m/s: far above the rounding of
/// other engines' steps, far below what a contact does.
constexpr double kSameState = 1e-5, kSameVelocity = 1e-5;
/// Same for the rotation, rad: larger, because other engines integrate it to first order.
constexpr double kFlightTurn = 1e-2;
constexpr int kPathPieces = 8;  ///< of the path between two states

bool is_flight(const RigidBody& body, const MotionStep& step, double gravity) {
  const RigidState end = free_flight(body, step.begin, step.end_time - step.begin_time, gravity);
  return (end.position - step.end.position).norm() < kSameState &&
         (end.velocity - step.end.velocity).norm() < kSameVelocity &&
         end.orientation.angularDistance(step.end.orientation) < kFlightTurn;
}

double kinetic_energy(const RigidBody& body, const RigidState& state) {
  return translational_energy(body, state) + rotational_energy(body, state);
}

EnergyBalance energies(const RigidBody& body, const RigidState& first, const RigidState& last,
                       double gravity) {
  const auto energy = [&](const RigidState& state) {
    return kinetic_energy(body, state) + body.mass * gravity * state.position.z();
  };
  return {.initial = energy(first),
          .final = energy(last),
          .normal = kNotKnown,
          .friction = kNotKnown,
          .rolling = kNotKnown,
          .reassigned = kNotKnown,
          .error = kNotKnown};
}

double path_length(const RigidBody& body, const MotionStep& step, double gravity) {
  double length = 0.0;
  Vec3 from = step.begin.position;
  for (int i = 1; i <= kPathPieces; ++i) {
    const double share = static_cast<double>(i) / kPathPieces;
    const double time = step.begin_time + share * (step.end_time - step.begin_time);
    const Vec3 to = i == kPathPieces ? step.end.position
                                     : interpolate_state(body, step, time, gravity).position;
    length += (to - from).norm();
    from = to;
  }
  return length;
}

}  // namespace

StoredRun make_run_from_states(const CampaignPlan& prepared, const RunRecord& planned,
                               const StateSeries& series, const RunEnding& end) {
  const RigidBody body = prepared.bodies[planned.block];
  const double gravity = prepared.campaign.gravity;
  StoredRun run;
  run.record = planned;
  ReleaseResult& result = run.record.result;
  ContactStatistics& contacts = run.record.contacts;
  result.stop_reason = end.reason;
  result.message = end.message;
  result.duration = series.time.back();
  result.final_state = series.states.back();
  result.max_penetration = result.settled_penetration = kNotKnown;
  contacts.contact_time = contacts.mean_contact_points = contacts.longest_flight = kNotKnown;
  for (const RigidState& state : series.states) {
    result.max_speed = std::max(result.max_speed, state.velocity.norm());
    contacts.max_energy = std::max(contacts.max_energy, kinetic_energy(body, state));
    contacts.max_spin = std::max(contacts.max_spin, state.angular_velocity.norm());
  }
  for (std::size_t i = 1; i < series.states.size(); ++i) {
    MotionStep step;
    step.begin_time = series.time[i - 1];
    step.end_time = series.time[i];
    step.begin = series.states[i - 1];
    step.end = series.states[i];
    step.flight = is_flight(body, step, gravity);
    result.path_length += path_length(body, step, gravity);
    for (std::uint32_t barrier = 0; barrier < prepared.header.barriers.size(); ++barrier) {
      for (Crossing& crossing : find_crossings(prepared.header.barriers[barrier], body, step,
                                               *prepared.surface, gravity)) {
        crossing.run = planned.run;
        crossing.barrier = barrier;
        run.crossings.push_back(crossing);
      }
    }
  }
  std::stable_sort(run.crossings.begin(), run.crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.time < b.time; });
  result.energy = energies(body, series.states.front(), series.states.back(), gravity);
  const Vec3& place = result.final_state.position;
  const std::optional<double> ground = prepared.surface->height_at(place.x(), place.y(), place.z());
  result.below_ground = ground && place.z() < *ground;
  run.trajectory = {series.time, series.states};
  return run;
}

std::size_t find_first_state_off_terrain(const CampaignPlan& prepared, const StateSeries& series) {
  const auto found =
      std::find_if(series.states.begin(), series.states.end(), [&](const RigidState& state) {
        return !prepared.surface->covers(state.position.x(), state.position.y());
      });
  return static_cast<std::size_t>(found - series.states.begin());
}

bool is_at_rest_at_end(const CampaignPlan& prepared, const RunRecord& planned,
                       const StateSeries& series) {
  const RigidBody body = prepared.bodies[planned.block];
  std::size_t first = series.states.size();
  while (first > 0 && kinetic_energy(body, series.states[first - 1]) <
                          prepared.campaign.rest_energy * body.mass) {
    --first;
  }
  return first + 1 < series.states.size() &&
         series.time.back() - series.time[first] >= prepared.campaign.rest_duration;
}

}  // namespace clast::study_detail

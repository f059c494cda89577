#include "dem/simulation/release.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "dem/contact/contact_forces.hpp"
#include "dem/contact/impact_energy_correction.hpp"
#include "dem/contact/stiffness.hpp"
#include "dem/motion/free_flight.hpp"
#include "dem/motion/rigid_body_integrator.hpp"
#include "dem/search/edge_penetration.hpp"
#include "dem/search/terrain_narrow_phase.hpp"
#include "dem/simulation/detail/time_step.hpp"
#include "dem/surface/terrain_impl.hpp"

namespace clast {

using namespace dem_detail;

namespace {

/// A flight ends within this time of the first contact, s.
constexpr double kLandingTime = 5e-10;
/// Growth of the time step in the search for the first contact, if no contact was found.
constexpr double kLookFarther = 8.0;
/// A block at rest is lost if it is deeper than this factor times its settled depth.
constexpr double kSettledSlack = 1.1;

/// Run in progress.
class Release {
 public:
  /// @param surface  surface of `body.shape`
  Release(const TerrainSurface& terrain, std::span<const GroundParameters> zones,
          const RigidBody& body, const BlockSurface& surface, const RigidState& start,
          const ReleaseSettings& settings, const MotionObserver& observe)
      : terrain_(terrain),
        zones_(zones),
        body_(body),
        settings_(settings),
        observe_(observe),
        surface_(surface),
        search_(terrain.impl().surface, surface_, body.size()),
        rules_(zones, terrain.impl().zones, settings.stiffness, settings.weighting, settings.law),
        forces_(rules_, surface_, body.size()),
        integrator_(body, start),
        mobilities_(vertex_mobilities(body)),
        largest_mobility_(*std::max_element(mobilities_.begin(), mobilities_.end())),
        radius_(body.bounding_radius()) {}

  ReleaseResult run() {
    update_contacts(integrator_.current_motion(), 0.0);
    result_.energy = {};
    result_.energy.initial = energy();
    if (std::any_of(zones_.begin(), zones_.end(), ImpactEnergyCorrection::applies_to)) {
      impact_correction_.emplace(result_.energy.initial);
    }
    while (true) {
      if (const std::optional<StopReason> reason = stop_reason()) {
        result_.stop_reason = *reason;
        break;
      }
      if (forces_.empty()) {
        advance_flight();
      } else {
        step();
      }
    }
    finish();
    return result_;
  }

  double start_overlap() {
    update_contacts(integrator_.current_motion(), 0.0);
    return std::max(forces_.max_overlap(),
                    edge_penetration_depth(terrain_.impl().surface, surface_,
                                           integrator_.state().world_from_body()));
  }

 private:
  std::optional<StopReason> stop_reason() {
    if (!integrator_.is_finite()) {
      result_.message = "the motion is no longer finite at " + format_significant(time_, 6) + " s";
      return StopReason::kError;
    }
    if (left_) return StopReason::kLeftTerrain;
    if (resting_ >= settings_.rest_duration) return StopReason::kRest;
    if (time_ >= settings_.max_time) return StopReason::kMaxTime;
    return std::nullopt;
  }

  /// Returns a time of flight without contact, s.
  double find_contact_free_flight_time() {
    const double spin = flight_->max_angular_speed(), g = settings_.gravity;
    // Bound of the acceleration by rotation: centripetal and Euler acceleration.
    const double uneven = body_.moments.maxCoeff() / body_.moments.minCoeff();
    return search_.find_contact_free_flight_time(
        {.velocity = integrator_.state().velocity,
         .spin = integrator_.state().angular_velocity,
         .rotational_acceleration = uneven * spin * spin,
         .acceleration = g + uneven * spin * spin * radius_,
         .max_point_speed = integrator_.state().velocity.norm() + spin * radius_,
         .gravity = g},
        max_time_step());
  }

  /// Moves to another time of the flight and searches for contacts there.
  const std::vector<ContactPoint>& look_at(double flown) {
    const double g = settings_.gravity, time = std::abs(flown - flown_);
    displacement_ +=
        (integrator_.state().velocity.norm() + flight_->max_angular_speed() * radius_) * time +
        0.5 * g * time * time;
    flown_ = flown;
    integrator_.set_state(flight_->state_after(flown));
    return search_.find_contacts(integrator_.state().world_from_body(), displacement_);
  }

  /// Flies for the contact-free time or at least the longest step, not beyond the first contact.
  void advance_flight() {
    const RigidState begin = integrator_.state();
    if (!flight_) {
      flight_.emplace(body_, begin, settings_.gravity);
      flown_ = 0.0;
    }
    const double before = flown_;
    double end = before + std::min(std::max(find_contact_free_flight_time(), max_time_step()),
                                   settings_.max_time - time_);
    const auto inside = [&](double flown) {
      const RigidState& from = flight_->begin();
      return terrain_.covers(from.position.x() + flown * from.velocity.x(),
                             from.position.y() + flown * from.velocity.y());
    };
    if (!inside(end)) {
      // The run ends when the centre passes the border of the terrain.
      double within = before;
      while (end - within > 1e-9) {
        const double middle = 0.5 * (within + end);
        (inside(middle) ? within : end) = middle;
      }
      left_ = true;
    }
    if (!look_at(end).empty()) {
      land(before);
      left_ = left_ && !inside(flown_);
    }
    const double duration = flown_ - before;
    forces_.advance_time(duration);
    const double middle_speed =
        (begin.velocity - Vec3(0.0, 0.0, 0.5 * settings_.gravity * duration)).norm();
    result_.path_length +=
        duration / 6.0 *
        (begin.velocity.norm() + 4.0 * middle_speed + integrator_.state().velocity.norm());
    resting_ = 0.0;
    ++result_.flight_segments;
    update_contacts(integrator_.current_motion(), 0.0);
    step_length_ = 0.0;
    advance(begin, duration, true);
  }

  /// Goes back from a time with contact to the first, by bracketed Newton's method on the overlap.
  /// @param clear  time of the flight without contact, s
  void land(double clear) {
    double touching = flown_, look_farther = kLandingTime;
    const std::vector<ContactPoint>* contacts =
        &search_.find_contacts(integrator_.state().world_from_body(), displacement_);
    while (touching - clear > kLandingTime) {
      double next = 0.5 * (clear + touching);
      if (!contacts->empty()) {
        const double since = time_since_touch(*contacts);
        if (since <= kLandingTime) return;
        next = std::max(touching - since + 0.5 * kLandingTime, clear + 0.5 * kLandingTime);
        if (!(next < touching)) next = 0.5 * (clear + touching);
      } else {
        next = std::min(clear + look_farther, next);
        look_farther *= kLookFarther;
      }
      contacts = &look_at(next);
      (contacts->empty() ? clear : touching) = next;
    }
    if (contacts->empty()) look_at(touching);
  }

  /// Returns the largest time since a contact began, to first order, s.
  double time_since_touch(const std::vector<ContactPoint>& contacts) const {
    const BodyMotion motion = integrator_.current_motion();
    double longest = 0.0;
    for (const ContactPoint& contact : contacts) {
      const double closing = -motion.velocity_at(contact.position()).dot(contact.normal);
      longest = std::max(longest, closing > 0.0 ? contact.overlap / closing : 1e300);
    }
    return longest;
  }

  double max_time_step() const {
    return std::max(settings_.stiffness.time_step, settings_.stiffness.max_time_step);
  }

  /// Returns the time step that the present contacts need, s.
  double needed_step() const {
    const ContactStiffness& contact = settings_.stiffness;
    if (!allows_longer_steps(contact)) return contact.time_step;
    const double specific =
        std::max(integrator_.kinetic_energy() / body_.mass, settings_.rest_energy);
    return contact_time_step(contact, forces_.contact_mobility(mobilities_) / largest_mobility_,
                             is_impact(load_.impact_energy, specific));
  }

  void step() {
    flight_.reset();
    const RigidState begin = integrator_.state();
    const Vec3 gravity(0.0, 0.0, -settings_.gravity);
    const double dt = std::min(needed_step(), settings_.max_time - time_);
    if (dt != step_length_) {
      // The energy that Verlet steps conserve depends on their length.
      const auto kick = [&](double length) {
        return integrator_.verlet_start_loss(length, load_.force, load_.torque, gravity);
      };
      result_.energy.reassigned += kick(dt) - kick(step_length_);
      step_length_ = dt;
    }
    if (impact_correction_) {
      impact_correction_->add_touched_zone(zones_[forces_.deepest_contact()->zone]);
      impact_correction_->add_contact_load(0.5 * dt, load_);
    }
    const BodyMotion motion = integrator_.begin_step(dt, load_.force, load_.torque, gravity);
    displacement_ += dt * integrator_.max_point_speed();
    result_.path_length += dt * motion.velocity.norm();
    update_contacts(motion, dt);
    if (impact_correction_) impact_correction_->add_contact_load(0.5 * dt, load_);
    integrator_.end_step(dt, load_.force, load_.torque, gravity);
    if (load_.correction) {
      const CorrectionImpulse& event = *load_.correction;
      result_.energy.reassigned -= integrator_.apply_correction_impulse(
          event.impulse, event.angular_impulse, event.moment, event.angular_moment, gravity);
      displacement_ += integrator_.correction_displacement();
      if (impact_correction_) impact_correction_->add_correction_impulse(event);
    }
    if (impact_correction_ && forces_.empty()) end_impact();
    ++result_.contact_steps;

    const double specific = integrator_.kinetic_energy() / body_.mass;
    resting_ = !forces_.empty() && specific < settings_.rest_energy ? resting_ + dt : 0.0;
    const Vec3& position = integrator_.state().position;
    if (!terrain_.covers(position.x(), position.y())) left_ = true;
    advance(begin, dt, false);
  }

  /// Ends a corrected impact. Books the energy that its correction and its steps reassigned.
  void end_impact() {
    if (!impact_correction_->end_impact(integrator_, energy() + dissipated_by_law())) return;
    result_.energy.reassigned = result_.energy.initial - energy() - dissipated_by_law();
  }

  double dissipated_by_law() const {
    return result_.energy.normal + result_.energy.friction + result_.energy.rolling;
  }

  /// Returns the energy at the end, J. If a corrected impact is in progress, its remaining energy
  /// counts as stored in the contacts.
  double final_energy() {
    const std::optional<double> due =
        impact_correction_ ? impact_correction_->expected_energy() : std::nullopt;
    if (!due) return energy();
    result_.energy.reassigned = result_.energy.initial - *due;
    return *due - dissipated_by_law();
  }

  void update_contacts(const BodyMotion& motion, double dt) {
    const bool flying = forces_.empty();
    load_ = forces_.update_loads(search_.find_contacts(motion.world_from_body, displacement_),
                                 motion, {}, dt, result_.energy);
    if (flying && !forces_.empty() && time_ > 0.0) ++result_.impacts;
    result_.max_penetration = std::max(result_.max_penetration, forces_.max_overlap());
  }

  void advance(const RigidState& begin, double duration, bool flight) {
    const double end_time = time_ + duration;
    const bool correction_pending = impact_correction_ && impact_correction_->expected_energy();
    double& fastest = result_.max_speed;
    if (!to_be_balanced_) fastest = std::max(fastest, begin.velocity.norm());
    if (!correction_pending) fastest = std::max(fastest, integrator_.state().velocity.norm());
    to_be_balanced_ = correction_pending;
    if (observe_) {
      observe_({time_, end_time, begin, integrator_.state(), flight, contact_summary(),
                correction_pending});
    }
    time_ = end_time;
  }

  ContactSummary contact_summary() const {
    const std::optional<ContactForces::DeepestContact> deepest = forces_.deepest_contact();
    if (!deepest) return {};
    return {deepest->contact_count, deepest->overlap, deepest->position, deepest->zone};
  }

  double energy() const {
    return integrator_.kinetic_energy() +
           body_.mass * settings_.gravity * integrator_.state().position.z() +
           forces_.stored_energy();
  }

  void finish() {
    result_.duration = time_;
    result_.final_state = integrator_.state();
    const Vec3& position = integrator_.state().position;
    result_.settled_penetration = forces_.max_overlap();
    EnergyBalance& energy_balance = result_.energy;
    // Potential energy is relative to the final height, to make the error independent of the datum.
    energy_balance.close_balance(
        final_energy(), energy_balance.initial - body_.mass * settings_.gravity * position.z());
    const std::optional<double> ground =
        terrain_.height_at(position.x(), position.y(), position.z());
    result_.below_ground = (ground && position.z() < *ground) ||
                           (result_.stop_reason == StopReason::kRest &&
                            forces_.compute_settled_depth() > kSettledSlack * deepest_rest());
  }

  /// Returns the largest possible depth of a block at rest, m: by its weight, or for plastic laws
  /// by an impact with all its energy.
  double deepest_rest() const {
    const double weight = body_.mass * settings_.gravity;
    if (!forces_.is_plastic()) return weight / forces_.static_stiffness();
    const double drop = result_.energy.initial - weight * integrator_.state().position.z();
    return std::sqrt(2.0 * std::max(0.0, drop) / settings_.stiffness.normal);
  }

  const TerrainSurface& terrain_;
  std::span<const GroundParameters> zones_;
  const RigidBody& body_;
  const ReleaseSettings& settings_;
  const MotionObserver& observe_;
  const BlockSurface& surface_;
  TerrainNarrowPhase search_;
  ContactModel rules_;
  ContactForces forces_;
  RigidBodyIntegrator integrator_;
  std::vector<double> mobilities_;  ///< mobilities of the block's vertices, 1/kg
  double largest_mobility_;
  double radius_;
  ContactLoad load_;
  std::optional<ImpactEnergyCorrection> impact_correction_;  ///< only if a zone needs it
  bool to_be_balanced_ = false;                              ///< `MotionStep::correction_pending`
  std::optional<FreeFlight> flight_;                         ///< flight in progress
  double flown_ = 0.0;                                       ///< time since the flight began, s
  double time_ = 0.0;
  double displacement_ = 0.0;
  double step_length_ = 0.0;  ///< of the last step, 0 in flight, s
  double resting_ = 0.0;
  bool left_ = false;
  ReleaseResult result_;
};

}  // namespace

std::string name_of(StopReason reason) {
  switch (reason) {
    case StopReason::kRest:
      return "rest";
    case StopReason::kLeftTerrain:
      return "left_terrain";
    case StopReason::kMaxTime:
      return "max_time";
    case StopReason::kError:
      return "error";
  }
  return "error";
}

void ReleaseSettings::check() const {
  MotionSettings::check();
  if (!(max_time > 0.0 && std::isfinite(max_time))) {
    throw InputError("max_time = " + format_significant(max_time, 6) + "; must be above 0");
  }
}

RigidState interpolate_state(const RigidBody& body, const MotionStep& step, double time,
                             double gravity) {
  if (step.flight) return free_flight(body, step.begin, time - step.begin_time, gravity);
  const double duration = step.end_time - step.begin_time;
  const double fraction = duration > 0.0 ? (time - step.begin_time) / duration : 1.0;
  const double s2 = fraction * fraction, s3 = s2 * fraction;
  RigidState state;
  state.position = (2 * s3 - 3 * s2 + 1) * step.begin.position +
                   (s3 - 2 * s2 + fraction) * duration * step.begin.velocity +
                   (3 * s2 - 2 * s3) * step.end.position + (s3 - s2) * duration * step.end.velocity;
  state.velocity = (1.0 - fraction) * step.begin.velocity + fraction * step.end.velocity;
  state.orientation = step.begin.orientation.slerp(fraction, step.end.orientation);
  state.angular_velocity =
      (1.0 - fraction) * step.begin.angular_velocity + fraction * step.end.angular_velocity;
  return state;
}

ReleaseResult simulate_release(const TerrainSurface& terrain,
                               std::span<const GroundParameters> zones, const RigidBody& body,
                               const RigidState& start, const ReleaseSettings& settings,
                               const MotionObserver& observe) {
  settings.check();
  body.check("block");
  for (const GroundParameters& zone : zones) {
    if (zone.soil_memory > 0.0) {
      throw InputError("soil_memory = " + format_significant(zone.soil_memory, 6) +
                       ": residual indentations of a single release meet no later blocks; give 0");
    }
  }
  check_zone_parameters(terrain, zones);
  check_start_position(terrain, start.position, "the block");
  const BlockSurface surface(body.shape);
  const double overlap =
      Release(terrain, zones, body, surface, start, settings, observe).start_overlap();
  if (overlap > settings.start_overlap * body.smallest_side) {
    throw SimulationError("the block starts inside the ground, " + format_significant(overlap, 6) +
                          " m deep; raise the release point or give height_m");
  }
  return Release(terrain, zones, body, surface, start, settings, observe).run();
}

}  // namespace clast

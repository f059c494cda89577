#include "dem/simulation/detail/world_motion.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast::dem_detail {

namespace {

/// Number of bodies that a thread takes at a time.
constexpr std::size_t kBodiesAtATime = 16;

/// Adds the events of one pair to those of one of its bodies.
void add_body_event(std::optional<CorrectionImpulse>& sum, const CorrectionImpulse& event,
                    bool is_block) {
  if (!sum) sum.emplace();
  sum->impulse += is_block ? event.impulse : Vec3(-event.impulse);
  sum->angular_impulse += is_block ? event.angular_impulse : event.angular_impulse_on_other;
  if (!is_block) return;  // only a block against a fixed body is shifted
  sum->moment += event.moment;
  sum->angular_moment += event.angular_moment;
}

}  // namespace

std::string name_of_body(std::size_t body) { return "body " + std::to_string(body); }

WorldMotion::WorldMotion(std::vector<RigidBody> of_shapes, const WorldSettings& with,
                         const TerrainSurface* on, std::vector<GroundParameters> ground_zones)
    : settings_(with), terrain_(on), zones_(std::move(ground_zones)), team_(with.threads) {
  settings_.check();
  for (const GroundParameters& zone : zones_) zone.check("zone");
  if (soil_.is_enabled() &&
      !std::visit([]<NormalForceLaw Law>(const Law&) { return Law::kIsPlastic; }, with.law)) {
    throw InputError(
        "soil_memory of a ground zone needs the law elastoplastic, which leaves residual "
        "indentations");
  }
  if (terrain_) check_zone_parameters(*terrain_, zones_);
  shapes_.reserve(of_shapes.size());
  for (RigidBody& body : of_shapes) {
    body.check("shape " + std::to_string(shapes_.size()));
    shapes_.emplace_back(std::move(body));
  }
}

void WorldMotion::add_body(std::size_t shape, const RigidState& start, bool fixed) {
  invalidate_lists();
  const WorldBody& body = bodies_.emplace_back(shapes_[shape], start, fixed);
  if (!fixed) initial_ += body.energy(settings_.gravity);
}

void WorldMotion::remove_body(std::size_t body) {
  prepare_new_bodies();
  if (bodies_[body].inactive) return;
  sleep_manager_.wake_around(static_cast<std::uint32_t>(body), bodies_, pairs_);
  deactivate(body);
  pairs_.update_pairs(bodies_);
  invalidate_lists();
  reapply_loads();
}

void WorldMotion::advance(double longest) {
  prepare_new_bodies();
  update_moving_list();
  TimeStep step = choose_time_step(bodies_, moving_, pairs_, settings_);
  step.length = std::min(step.length, longest);
  const double dt = step.length;
  set_step_length(dt);
  if (observer_) record_start_states();
  begin_body_steps(step);
  update_all_pairs();
  pairs_.update_contacts(bodies_, dt, team_);
  wake_touched();
  end_body_steps(dt, step.flight);
  const double begin = time_;
  time_ += dt;
  ++steps_;
  for (const std::uint32_t i : moving_) {
    if (!bodies_[i].integrator.is_finite()) {
      throw SimulationError("the motion of " + name_of_body(i) + " is no longer finite at " +
                            format_significant(time_, 6) + " s; a shorter time step may help");
    }
  }
  if (observer_) notify_observer(begin);
  remove_bodies_off_terrain();
  if (settings_.sleep_drift > 0.0) put_to_sleep();
  if (soil_.is_enabled()) pairs_.store_indentations(bodies_, soil_);
}

void WorldMotion::update_moving_list() {
  if (listed_) return;
  moving_.clear();
  awake_.clear();
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].asleep) awake_.push_back(i);
    if (!bodies_[i].is_idle()) moving_.push_back(i);
  }
  pairs_.update_active_list(bodies_);
  listed_ = true;
}

void WorldMotion::update_all_pairs() {
  const std::uint64_t before = pairs_.broad_phase_count();
  if (positions_known_) {
    pairs_.update_pairs(bodies_, moving_);
  } else {
    pairs_.update_pairs(bodies_);
  }
  positions_known_ = true;
  if (pairs_.broad_phase_count() != before) pairs_.update_active_list(bodies_);
}

void WorldMotion::wake_touched() {
  const std::size_t before = sleep_manager_.count();
  sleep_manager_.wake_touched(bodies_, pairs_);
  if (sleep_manager_.count() != before) invalidate_lists();
}

void WorldMotion::put_to_sleep() {
  const std::size_t before = sleep_manager_.count();
  reassigned_ += sleep_manager_.put_to_sleep(bodies_, moving_, pairs_);
  if (sleep_manager_.count() != before) invalidate_lists();
}

void WorldMotion::prepare_new_bodies() {
  if (prepared_count_ == bodies_.size()) return;
  begin_new_pairs(
      [this](const ContactPair& pair) { return !pair.has_bodies_below(prepared_count_); });
  prepared_count_ = bodies_.size();
}

void WorldMotion::release_bodies(std::span<const std::size_t> bodies) {
  prepare_new_bodies();
  std::vector<bool> was_still;
  for (const WorldBody& body : bodies_) was_still.push_back(body.is_immobile());
  for (const std::size_t i : bodies) {
    WorldBody& body = bodies_[i];
    body.fixed = false;
    body.apply_motion(body.integrator.current_motion());
    initial_ += body.energy(settings_.gravity);
  }
  pairs_.request_broad_phase();
  begin_new_pairs([&](const ContactPair& pair) {
    return was_still[pair.block] &&
           (pair.reference == ContactPair::kTerrain || was_still[pair.reference]);
  });
}

void WorldMotion::begin_new_pairs(const IsNew& is_new) {
  pairs_.update_slack(bodies_);
  // Bodies that start in contact add the energy stored in it.
  const double before = losses().reassigned;
  pairs_.update_pairs(bodies_);
  invalidate_lists();
  update_moving_list();
  pairs_.begin_contacts(bodies_, is_new);
  const double brought = losses().reassigned - before;
  reassigned_ -= brought;
  initial_ -= brought;
  check_start_overlaps(is_new);
  wake_touched();
  reapply_loads();
}

void WorldMotion::check_start_overlaps(const IsNew& is_new) const {
  for (const ContactPair& pair : pairs_.all_pairs()) {
    if (!is_new(pair)) continue;
    const BodyShape& block = *bodies_[pair.block].shape;
    double size = block.body.size();
    if (pair.reference != ContactPair::kTerrain) {
      size = std::min(size, bodies_[pair.reference].shape->body.size());
    }
    const double overlap = pair.contacts->max_overlap();
    if (overlap <= settings_.start_overlap * size) continue;
    const std::string other =
        pair.reference == ContactPair::kTerrain ? "the ground" : name_of_body(pair.reference);
    throw SimulationError(name_of_body(pair.block) + " starts inside " + other + ", " +
                          format_significant(overlap, 6) + " m deep; place it farther away");
  }
}

/// Sums the loads of all bodies again between two steps, after pairs have changed.
void WorldMotion::reapply_loads() {
  reassigned_ -= verlet_start_losses(step_length_);
  end_body_steps(0.0, false);
  reassigned_ += verlet_start_losses(step_length_);
}

/// The energy that Verlet steps conserve depends on their length.
void WorldMotion::set_step_length(double dt) {
  if (dt == step_length_) return;
  reassigned_ += verlet_start_losses(dt) - verlet_start_losses(step_length_);
  step_length_ = dt;
}

double WorldMotion::verlet_start_losses(double dt) {
  update_moving_list();
  double sum = 0.0;
  for (const std::uint32_t i : moving_) {
    const WorldBody& body = bodies_[i];
    sum += body.integrator.verlet_start_loss(dt, body.force, body.torque, gravity());
  }
  return sum;
}

void WorldMotion::begin_body_steps(const TimeStep& step) {
  team_.run(moving_.size(), kBodiesAtATime, [&](std::size_t of_moving) {
    WorldBody& body = bodies_[moving_[of_moving]];
    body.apply_motion(
        step.flight ? body.integrator.advance_flight(step.length, gravity())
                    : body.integrator.begin_step(step.length, body.force, body.torque, gravity()));
  });
}

void WorldMotion::end_body_steps(double dt, bool flight) {
  update_moving_list();
  team_.run(awake_.size(), kBodiesAtATime, [&](std::size_t of_awake) {
    const std::uint32_t i = awake_[of_awake];
    WorldBody& body = bodies_[i];
    body.force = body.torque = Vec3::Zero();
    body.correction_energy = 0.0;
    std::uint64_t touching = 0, as_block = 0;
    std::optional<CorrectionImpulse> events;
    for (const std::uint32_t e : pairs_.pairs_of(i)) {
      const ContactPair& pair = pairs_.all_pairs()[e];
      if (!pair.has_load) continue;
      const ContactLoad& load = pair.contacts->load();
      const bool is_block = pair.block == i;
      body.force += is_block ? load.force : Vec3(-load.force);
      body.torque += is_block ? load.torque : load.torque_on_other;
      if (load.correction) add_body_event(events, *load.correction, is_block);
      if (!pair.contacts->is_touching()) continue;
      ++touching;
      if (is_block) ++as_block;
    }
    body.touching = touching > 0;
    if (body.is_immobile()) return;
    if (!flight) body.integrator.end_step(dt, body.force, body.torque, gravity());
    if (events && dt > 0.0) {  // otherwise they were applied at the end of the previous step
      body.correction_energy = body.integrator.apply_correction_impulse(
          events->impulse, events->angular_impulse, events->moment, events->angular_moment,
          gravity());
    }
    const double specific = body.integrator.kinetic_energy() / body.shape->body.mass;
    body.resting_time =
        touching > 0 && specific < settings_.rest_energy ? body.resting_time + dt : 0.0;
    if (touching > 0 && specific < kRockingEnergyFactor * settings_.rest_energy) {
      body.sleep_detector.add_step(body.integrator.state(), dt, settings_.sleep_duration,
                                   settings_.sleep_drift * body.shape->body.size(),
                                   body.shape->radius);
    } else {
      body.sleep_detector.reset();
    }
    body.pair_steps += as_block;
    const Vec3& position = body.integrator.state().position;
    body.off_terrain = terrain_ && !terrain_->covers(position.x(), position.y());
  });
  for (const std::uint32_t i : awake_) reassigned_ -= bodies_[i].correction_energy;
}

void WorldMotion::remove_bodies_off_terrain() {
  for (const std::uint32_t i : moving_) {
    if (bodies_[i].off_terrain) deactivate(i);
  }
}

void WorldMotion::deactivate(std::size_t body) {
  pairs_.end_contacts_of(static_cast<std::uint32_t>(body), bodies_);
  if (soil_.is_enabled()) pairs_.store_indentations(bodies_, soil_);
  bodies_[body].inactive = true;
  bodies_[body].apply_motion(bodies_[body].motion_at_rest());
  invalidate_lists();
}

void WorldMotion::record_start_states() {
  start_states_.clear();
  for (const std::uint32_t i : moving_) {
    start_states_.push_back({i, bodies_[i].integrator.state(), !bodies_[i].touching});
  }
}

void WorldMotion::notify_observer(double begin) {
  team_.run(start_states_.size(), kBodiesAtATime, [&](std::size_t of_began) {
    const StartState& start_state = start_states_[of_began];
    observer_(start_state.body, {.begin_time = begin,
                                 .end_time = time_,
                                 .begin = start_state.state,
                                 .end = bodies_[start_state.body].integrator.state(),
                                 .flight = start_state.free,
                                 .contact_summary = contact_summary(start_state.body)});
  });
}

ContactSummary WorldMotion::contact_summary(std::size_t body) const {
  ContactSummary sum;
  if (!is_prepared(body) || !bodies_[body].touching) return sum;
  bool on_ground = false;
  for (const std::uint32_t e : pairs_.pairs_of(body)) {
    const ContactPair& pair = pairs_.all_pairs()[e];
    if (!pair.has_load) continue;
    const std::optional<ContactForces::DeepestContact> deepest = pair.contacts->deepest_contact();
    if (!deepest) continue;
    sum.contact_count += deepest->contact_count;
    if (pair.reference == ContactPair::kTerrain) {
      on_ground = true;
      sum.zone = deepest->zone;
    }
    if (deepest->overlap <= sum.overlap) continue;
    sum.overlap = deepest->overlap;
    sum.position = deepest->position;
  }
  if (sum.contact_count > 0 && !on_ground && terrain_) {
    sum.zone = terrain_->zone_at(sum.position.x(), sum.position.y(), sum.position.z()).value_or(0);
  }
  return sum;
}

EnergyBalance WorldMotion::energy_balance() const {
  EnergyBalance energy_balance = losses();
  energy_balance.initial = initial_;
  double energy = pairs_.stored_energy();
  // Potential energy is relative to the final heights, to make the error independent of the datum.
  double datum = 0.0;
  for (const WorldBody& body : bodies_) {
    if (body.fixed) continue;
    energy += body.energy(settings_.gravity);
    datum += body.shape->body.mass * settings_.gravity * body.integrator.state().position.z();
  }
  energy_balance.close_balance(energy, energy_balance.initial - datum);
  return energy_balance;
}

EnergySample WorldMotion::energy_sample() const {
  const auto dissipation = [](const EnergyBalance& energy_balance) {
    return DissipatedEnergy{energy_balance.normal, energy_balance.friction, energy_balance.rolling};
  };
  EnergySample sample;
  sample.time = time_;
  const ContactPairTable::ContactLosses lost = pairs_.losses();
  sample.on_ground = dissipation(lost.on_ground);
  sample.between_bodies = dissipation(lost.between_bodies);
  sample.reassigned = losses().reassigned;
  sample.stored = pairs_.stored_energy();
  for (const WorldBody& body : bodies_) {
    if (body.fixed) continue;
    if (body.inactive) {
      sample.departed += body.energy(settings_.gravity);
      continue;
    }
    if (!is_resting(body)) ++sample.moving;
    const RigidBody& rigid = body.shape->body;
    const RigidState& state = body.integrator.state();
    sample.translational += 0.5 * rigid.mass * state.velocity.squaredNorm();
    sample.rotational += rotational_energy(rigid, state);
    sample.potential += rigid.mass * settings_.gravity * state.position.z();
  }
  return sample;
}

}  // namespace clast::dem_detail

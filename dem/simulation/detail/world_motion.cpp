#include "dem/simulation/detail/world_motion.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast::dem_detail {

namespace {

/// Bodies that a thread takes at a time.
constexpr std::size_t kBodiesAtATime = 16;

/// Adds the events of one pair to those of one of its bodies.
void add_body_event(std::optional<EventLoad>& sum, const EventLoad& event, bool is_block) {
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
  if (soil_.any() &&
      !std::visit([]<NormalLaw Law>(const Law&) { return Law::kIsPlastic; }, with.law)) {
    throw InputError(
        "soil_memory of a ground zone needs the law elastoplastic, which leaves dents");
  }
  if (terrain_) check_zones(*terrain_, zones_);
  shapes_.reserve(of_shapes.size());
  for (RigidBody& body : of_shapes) {
    body.check("shape " + std::to_string(shapes_.size()));
    shapes_.emplace_back(std::move(body));
  }
}

void WorldMotion::add(std::size_t shape, const RigidState& start, bool fixed) {
  motion_changed();
  const WorldBody& body = bodies_.emplace_back(shapes_[shape], start, fixed);
  if (!fixed) initial_ += body.energy(settings_.gravity);
}

void WorldMotion::remove(std::size_t body) {
  prepare();
  if (bodies_[body].gone) return;
  sleeping_.wake_around(static_cast<std::uint32_t>(body), bodies_, pairs_);
  take_out(body);
  pairs_.refresh(bodies_);
  motion_changed();
  apply_loads_anew();
}

void WorldMotion::advance(double longest) {
  prepare();
  list_moving();
  StepChoice step = choose_step(bodies_, moving_, pairs_, settings_);
  step.length = std::min(step.length, longest);
  const double dt = step.length;
  set_step_length(dt);
  if (observer_) note_begins();
  begin_moves(step);
  refresh_pairs();
  pairs_.update(bodies_, dt, team_);
  wake_touched();
  end_moves(dt, step.flight);
  const double begin = time_;
  time_ += dt;
  ++steps_;
  for (const std::uint32_t i : moving_) {
    if (!bodies_[i].moving.finite()) {
      throw SimulationError("the motion of " + name_of_body(i) + " is not finite any more at " +
                            format_significant(time_, 6) + " s; a shorter time step may help");
    }
  }
  if (observer_) show_moves(begin);
  remove_bodies_off_terrain();
  if (settings_.sleep_drift > 0.0) let_sleep();
  if (soil_.any()) pairs_.remember_dents(bodies_, soil_);
}

void WorldMotion::list_moving() {
  if (listed_) return;
  moving_.clear();
  awake_.clear();
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].asleep) awake_.push_back(i);
    if (!bodies_[i].idle()) moving_.push_back(i);
  }
  pairs_.list_active(bodies_);
  listed_ = true;
}

void WorldMotion::refresh_pairs() {
  const std::uint64_t before = pairs_.broad_phases();
  if (places_known_) {
    pairs_.refresh(bodies_, moving_);
  } else {
    pairs_.refresh(bodies_);
  }
  places_known_ = true;
  if (pairs_.broad_phases() != before) pairs_.list_active(bodies_);
}

void WorldMotion::wake_touched() {
  const std::size_t before = sleeping_.count();
  sleeping_.wake_touched(bodies_, pairs_);
  if (sleeping_.count() != before) motion_changed();
}

void WorldMotion::let_sleep() {
  const std::size_t before = sleeping_.count();
  reassigned_ += sleeping_.let_sleep(bodies_, moving_, pairs_);
  if (sleeping_.count() != before) motion_changed();
}

void WorldMotion::prepare() {
  if (prepared_ == bodies_.size()) return;
  begin_pairs([this](const ContactPair& pair) { return !pair.between(prepared_); });
  prepared_ = bodies_.size();
}

void WorldMotion::free(std::span<const std::size_t> bodies) {
  prepare();
  std::vector<bool> was_still;
  for (const WorldBody& body : bodies_) was_still.push_back(body.still());
  for (const std::size_t i : bodies) {
    WorldBody& body = bodies_[i];
    body.fixed = false;
    body.move(body.moving.motion());
    initial_ += body.energy(settings_.gravity);
  }
  pairs_.list_anew();
  begin_pairs([&](const ContactPair& pair) {
    return was_still[pair.block] &&
           (pair.reference == ContactPair::kTerrain || was_still[pair.reference]);
  });
}

void WorldMotion::begin_pairs(const IsNew& is_new) {
  pairs_.set_slack(bodies_);
  // Bodies that start in contact bring what is stored there.
  const double before = losses().reassigned;
  pairs_.refresh(bodies_);
  motion_changed();
  list_moving();
  pairs_.begin(bodies_, is_new);
  const double brought = losses().reassigned - before;
  reassigned_ -= brought;
  initial_ -= brought;
  refuse_deep_starts(is_new);
  wake_touched();
  apply_loads_anew();
}

void WorldMotion::refuse_deep_starts(const IsNew& is_new) const {
  for (const ContactPair& pair : pairs_.all()) {
    if (!is_new(pair)) continue;
    const Shape& block = *bodies_[pair.block].shape;
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

/// Between two steps, when pairs came or went.
void WorldMotion::apply_loads_anew() {
  reassigned_ -= first_kicks(step_length_);
  end_moves(0.0, false);
  reassigned_ += first_kicks(step_length_);
}

/// What Verlet steps conserve depends on their length.
void WorldMotion::set_step_length(double dt) {
  if (dt == step_length_) return;
  reassigned_ += first_kicks(dt) - first_kicks(step_length_);
  step_length_ = dt;
}

double WorldMotion::first_kicks(double dt) {
  list_moving();
  double sum = 0.0;
  for (const std::uint32_t i : moving_) {
    const WorldBody& body = bodies_[i];
    sum += body.moving.first_kick(dt, body.force, body.torque, gravity());
  }
  return sum;
}

void WorldMotion::begin_moves(const StepChoice& step) {
  team_.run(moving_.size(), kBodiesAtATime, [&](std::size_t of_moving) {
    WorldBody& body = bodies_[moving_[of_moving]];
    body.move(step.flight
                  ? body.moving.fly(step.length, gravity())
                  : body.moving.begin_step(step.length, body.force, body.torque, gravity()));
  });
}

void WorldMotion::end_moves(double dt, bool flight) {
  list_moving();
  team_.run(awake_.size(), kBodiesAtATime, [&](std::size_t of_awake) {
    const std::uint32_t i = awake_[of_awake];
    WorldBody& body = bodies_[i];
    body.force = body.torque = Vec3::Zero();
    body.corrected = 0.0;
    std::uint64_t touching = 0, as_block = 0;
    std::optional<EventLoad> events;
    for (const std::uint32_t e : pairs_.of(i)) {
      const ContactPair& pair = pairs_.all()[e];
      if (!pair.loads) continue;
      const ContactLoad& load = pair.contacts->load();
      const bool is_block = pair.block == i;
      body.force += is_block ? load.force : Vec3(-load.force);
      body.torque += is_block ? load.torque : load.torque_on_other;
      if (load.event) add_body_event(events, *load.event, is_block);
      if (!pair.contacts->touching()) continue;
      ++touching;
      if (is_block) ++as_block;
    }
    body.touching = touching > 0;
    if (body.still()) return;
    if (!flight) body.moving.end_step(dt, body.force, body.torque, gravity());
    if (events && dt > 0.0) {  // else they were applied at the end of the step before
      body.corrected = body.moving.correct(events->impulse, events->angular_impulse, events->moment,
                                           events->angular_moment, gravity());
    }
    const double specific = body.moving.kinetic_energy() / body.shape->body.mass;
    body.resting = touching > 0 && specific < settings_.rest_energy ? body.resting + dt : 0.0;
    if (touching > 0 && specific < kRocking * settings_.rest_energy) {
      body.watch.add(body.moving.state(), dt, settings_.sleep_duration,
                     settings_.sleep_drift * body.shape->body.size(), body.shape->radius);
    } else {
      body.watch.reset();
    }
    body.pair_steps += as_block;
    const Vec3& place = body.moving.state().position;
    body.off_terrain = terrain_ && !terrain_->covers(place.x(), place.y());
  });
  for (const std::uint32_t i : awake_) reassigned_ -= bodies_[i].corrected;
}

void WorldMotion::remove_bodies_off_terrain() {
  for (const std::uint32_t i : moving_) {
    if (bodies_[i].off_terrain) take_out(i);
  }
}

void WorldMotion::take_out(std::size_t body) {
  pairs_.end_contacts_of(static_cast<std::uint32_t>(body), bodies_);
  if (soil_.any()) pairs_.remember_dents(bodies_, soil_);
  bodies_[body].gone = true;
  bodies_[body].move(bodies_[body].without_motion());
  motion_changed();
}

void WorldMotion::note_begins() {
  began_.clear();
  for (const std::uint32_t i : moving_) {
    began_.push_back({i, bodies_[i].moving.state(), !bodies_[i].touching});
  }
}

void WorldMotion::show_moves(double begin) {
  team_.run(began_.size(), kBodiesAtATime, [&](std::size_t of_began) {
    const Begin& began = began_[of_began];
    observer_(began.body, {.begin_time = begin,
                           .end_time = time_,
                           .begin = began.state,
                           .end = bodies_[began.body].moving.state(),
                           .flight = began.free,
                           .touch = touch(began.body)});
  });
}

Touch WorldMotion::touch(std::size_t body) const {
  Touch sum;
  if (!prepared(body) || !bodies_[body].touching) return sum;
  bool on_ground = false;
  for (const std::uint32_t e : pairs_.of(body)) {
    const ContactPair& pair = pairs_.all()[e];
    if (!pair.loads) continue;
    const std::optional<ContactForces::Deepest> deepest = pair.contacts->deepest();
    if (!deepest) continue;
    sum.points += deepest->points;
    if (pair.reference == ContactPair::kTerrain) {
      on_ground = true;
      sum.zone = deepest->zone;
    }
    if (deepest->overlap <= sum.overlap) continue;
    sum.overlap = deepest->overlap;
    sum.place = deepest->place;
  }
  if (sum.points > 0 && !on_ground && terrain_) {
    sum.zone = terrain_->zone(sum.place.x(), sum.place.y(), sum.place.z()).value_or(0);
  }
  return sum;
}

EnergyLedger WorldMotion::energy() const {
  EnergyLedger ledger = losses();
  ledger.initial = initial_;
  double energy = pairs_.stored_energy();
  // The potential counts from the heights at the end, so that the scale does not depend on the
  // datum.
  double datum = 0.0;
  for (const WorldBody& body : bodies_) {
    if (body.fixed) continue;
    energy += body.energy(settings_.gravity);
    datum += body.shape->body.mass * settings_.gravity * body.moving.state().position.z();
  }
  ledger.close(energy, ledger.initial - datum);
  return ledger;
}

EnergySample WorldMotion::energy_sample() const {
  const auto dissipation = [](const EnergyLedger& ledger) {
    return Dissipation{ledger.normal, ledger.friction, ledger.rolling};
  };
  EnergySample sample;
  sample.time = time_;
  const ContactPairs::Losses lost = pairs_.losses();
  sample.on_ground = dissipation(lost.on_ground);
  sample.between_bodies = dissipation(lost.between_bodies);
  sample.reassigned = losses().reassigned;
  sample.stored = pairs_.stored_energy();
  for (const WorldBody& body : bodies_) {
    if (body.fixed) continue;
    if (body.gone) {
      sample.gone += body.energy(settings_.gravity);
      continue;
    }
    if (!resting(body)) ++sample.moving;
    const RigidBody& rigid = body.shape->body;
    const RigidState& state = body.moving.state();
    sample.translational += 0.5 * rigid.mass * state.velocity.squaredNorm();
    sample.rotational += rotational_energy(rigid, state);
    sample.potential += rigid.mass * settings_.gravity * state.position.z();
  }
  return sample;
}

}  // namespace clast::dem_detail

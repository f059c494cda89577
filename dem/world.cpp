#include "dem/world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "dem/detail/contact_pairs.hpp"
#include "dem/detail/rotation.hpp"
#include "dem/detail/sleeping.hpp"
#include "dem/detail/terrain_impl.hpp"

namespace clast {

using namespace dem_detail;

namespace {

/// A block whose mean place stays may rock with so many times the energy below which it rests.
constexpr double kRocking = 10.0;
/// Bodies that a thread takes at a time.
constexpr std::size_t kBodiesAtATime = 16;
constexpr std::uint32_t kTerrain = ContactPair::kTerrain;
/// How far an orientation's norm may be from 1 before it counts as a mistake.
constexpr double kUnitSlack = 1e-6;

/// Adds the events of one pair to those of one of its bodies.
void add_event(std::optional<EventLoad>& sum, const EventLoad& event, bool is_block) {
  if (!sum) sum.emplace();
  sum->impulse += is_block ? event.impulse : Vec3(-event.impulse);
  sum->angular_impulse += is_block ? event.angular_impulse : event.angular_impulse_on_other;
  if (!is_block) return;  // only a block against a fixed body is shifted
  sum->moment += event.moment;
  sum->angular_moment += event.angular_moment;
}

std::string name_of_body(std::size_t body) { return "body " + std::to_string(body); }

}  // namespace

struct World::Impl {
  Impl(std::vector<RigidBody> of_shapes, const WorldSettings& with, const TerrainSurface* on,
       std::vector<GroundParameters> ground_zones)
      : settings(with), terrain(on), zones(std::move(ground_zones)), team(with.threads) {
    settings.check();
    for (const GroundParameters& zone : zones) zone.check("zone");
    if (terrain && zones.size() < terrain->zone_count()) {
      throw SimulationError("terrain has " + std::to_string(terrain->zone_count()) +
                            " ground zones but parameters are given for " +
                            std::to_string(zones.size()));
    }
    shapes.reserve(of_shapes.size());
    for (RigidBody& body : of_shapes) {
      body.check("shape " + std::to_string(shapes.size()));
      shapes.emplace_back(std::move(body));
    }
  }

  BodyPair::Rules rules(std::span<const GroundParameters> of_zones,
                        std::span<const std::uint16_t> zone_of_face) const {
    return {of_zones, zone_of_face, settings.stiffness, settings.weights, settings.law};
  }

  void begin_moves(double dt);
  void end_moves(double dt);
  void prepare();
  void show_moves(double begin) const;
  Touch touch(std::size_t body) const;
  void remove_bodies_off_terrain();
  void advance(double dt);
  /// What Verlet steps lose when they begin with the present loads, J.
  double first_kicks() const;
  void refuse_deep_starts() const;
  EnergyLedger losses() const {
    EnergyLedger sum = pairs.losses();
    sum.reassigned += reassigned;
    return sum;
  }
  double energy_now() const;

  WorldSettings settings;
  const TerrainSurface* terrain;
  std::vector<GroundParameters> zones;
  std::vector<Shape> shapes;
  ThreadTeam team;

  std::vector<WorldBody> bodies;
  ContactPairs pairs{terrain, rules(std::span(&settings.between_bodies, 1), {}),
                     rules(zones, terrain ? std::span<const std::uint16_t>(terrain->impl().zones)
                                          : std::span<const std::uint16_t>())};
  std::size_t prepared = 0;  ///< bodies that are part of the motion already
  Sleeping sleeping;
  BodyObserver observer;
  std::vector<std::optional<RigidState>> began;  ///< of bodies that move in the step, if observed

  double time = 0.0;
  double initial = 0.0;     ///< energy that bodies brought, J
  double reassigned = 0.0;  ///< losses of no pair, J
  std::uint64_t steps = 0;
};

void World::Impl::begin_moves(double dt) {
  const Vec3 gravity(0.0, 0.0, -settings.gravity);
  team.run(bodies.size(), kBodiesAtATime, [&](std::size_t i) {
    WorldBody& body = bodies[i];
    if (!body.idle()) {
      body.motion = body.moving.begin_step(dt, body.force, body.torque, gravity);
    }
  });
}

void World::Impl::end_moves(double dt) {
  const Vec3 gravity(0.0, 0.0, -settings.gravity);
  team.run(bodies.size(), kBodiesAtATime, [&](std::size_t i) {
    WorldBody& body = bodies[i];
    if (body.asleep) return;
    body.force = body.torque = Vec3::Zero();
    body.corrected = 0.0;
    std::uint64_t touching = 0, as_block = 0;
    std::optional<EventLoad> events;
    for (const std::uint32_t e : pairs.of(i)) {
      const ContactPair& pair = pairs.all()[e];
      const ContactLoad& load = pair.contacts->load();
      const bool is_block = pair.block == i;
      body.force += is_block ? load.force : Vec3(-load.force);
      body.torque += is_block ? load.torque : load.torque_on_other;
      if (load.event) add_event(events, *load.event, is_block);
      if (!pair.contacts->touching()) continue;
      ++touching;
      if (is_block) ++as_block;
    }
    if (body.still()) return;
    body.moving.end_step(dt, body.force, body.torque, gravity);
    if (events && dt > 0.0) {  // else they were applied at the end of the step before
      body.corrected = body.moving.correct(events->impulse, events->angular_impulse, events->moment,
                                           events->angular_moment, gravity);
    }
    const double specific = body.moving.kinetic_energy() / body.shape->body.mass;
    body.resting = touching > 0 && specific < settings.rest_energy ? body.resting + dt : 0.0;
    if (touching > 0 && specific < kRocking * settings.rest_energy) {
      body.watch.add(body.moving.state(), dt, settings.sleep_duration,
                     settings.sleep_drift * body.shape->body.size(), body.shape->radius);
    } else {
      body.watch.reset();
    }
    body.pair_steps += as_block;
    const Vec3& place = body.moving.state().position;
    body.off_terrain = terrain && !terrain->covers(place.x(), place.y());
  });
  for (const WorldBody& body : bodies) {
    if (!body.asleep) reassigned -= body.corrected;
  }
}

double World::Impl::first_kicks() const {
  double sum = 0.0;
  for (const WorldBody& body : bodies) {
    if (body.idle()) continue;
    sum += body.moving.first_kick(settings.stiffness.time_step, body.force, body.torque,
                                  {0.0, 0.0, -settings.gravity});
  }
  return sum;
}

void World::Impl::prepare() {
  if (prepared == bodies.size()) return;
  pairs.set_slack(bodies);
  // Bodies that start in contact bring what is stored there.
  const double before = losses().reassigned;
  pairs.refresh(bodies);
  pairs.begin(bodies, prepared);
  const double brought = losses().reassigned - before;
  reassigned -= brought;
  initial -= brought;
  refuse_deep_starts();
  sleeping.wake_touched(bodies, pairs);
  reassigned -= first_kicks();
  end_moves(0.0);
  reassigned += first_kicks();
  prepared = bodies.size();
}

void World::Impl::refuse_deep_starts() const {
  for (const ContactPair& pair : pairs.all()) {
    if (pair.between(prepared)) continue;
    const Shape& block = *bodies[pair.block].shape;
    double size = block.body.size();
    if (pair.reference != kTerrain) {
      size = std::min(size, bodies[pair.reference].shape->body.size());
    }
    const double overlap = pair.contacts->max_overlap();
    if (overlap <= settings.start_overlap * size) continue;
    const std::string other =
        pair.reference == kTerrain ? "the ground" : name_of_body(pair.reference);
    throw SimulationError(name_of_body(pair.block) + " starts inside " + other + ", " +
                          with_digits(overlap, 6) + " m deep; place it farther away");
  }
}

void World::Impl::remove_bodies_off_terrain() {
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    WorldBody& body = bodies[i];
    if (body.idle() || !body.off_terrain) continue;
    pairs.end_contacts_of(i, bodies);
    body.left = true;
    body.motion = body.without_motion();
  }
}

double World::Impl::energy_now() const {
  double sum = 0.0;
  for (const WorldBody& body : bodies) {
    if (body.fixed) continue;
    sum += body.energy(settings.gravity);
  }
  return sum + pairs.stored_energy();
}

void World::Impl::advance(double dt) {
  prepare();
  if (observer) {
    began.assign(bodies.size(), std::nullopt);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!bodies[i].idle()) began[i] = bodies[i].moving.state();
    }
  }
  begin_moves(dt);
  pairs.refresh(bodies);
  pairs.update(bodies, dt, team);
  sleeping.wake_touched(bodies, pairs);
  end_moves(dt);
  const double begin = time;
  time += dt;
  ++steps;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].idle() && !bodies[i].moving.finite()) {
      throw SimulationError("the motion of " + name_of_body(i) + " is not finite any more at " +
                            with_digits(time, 6) + " s; a shorter time step may help");
    }
  }
  if (observer) show_moves(begin);
  remove_bodies_off_terrain();
  if (settings.sleep_drift > 0.0) reassigned += sleeping.let_sleep(bodies, pairs);
}

void World::Impl::show_moves(double begin) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!began[i]) continue;
    observer(i, {.begin_time = begin,
                 .end_time = time,
                 .begin = *began[i],
                 .end = bodies[i].moving.state(),
                 .flight = false,
                 .touch = touch(i)});
  }
}

Touch World::Impl::touch(std::size_t body) const {
  Touch sum;
  bool on_ground = false;
  for (const std::uint32_t e : pairs.of(body)) {
    const ContactPair& pair = pairs.all()[e];
    const std::optional<ContactForces::Deepest> deepest = pair.contacts->deepest();
    if (!deepest) continue;
    sum.points += deepest->points;
    if (pair.reference == kTerrain) {
      on_ground = true;
      sum.zone = deepest->zone;
    }
    if (deepest->overlap <= sum.overlap) continue;
    sum.overlap = deepest->overlap;
    sum.place = deepest->place;
  }
  if (sum.points > 0 && !on_ground && terrain) {
    sum.zone = terrain->zone(sum.place.x(), sum.place.y(), sum.place.z()).value_or(0);
  }
  return sum;
}

void WorldSettings::check() const {
  ReleaseSettings same;
  same.stiffness = stiffness;
  same.gravity = gravity;
  same.rest_energy = rest_energy;
  same.rest_duration = rest_duration;
  same.check();
  between_bodies.check("between bodies");
  const auto require = [](bool fine, const char* name, double value, const char* range) {
    if (fine) return;
    throw InputError(std::string(name) + " = " + with_digits(value, 6) + "; must be " + range);
  };
  require(sleep_drift >= 0.0, "sleep_drift", sleep_drift, "0 or more");
  require(sleep_duration > 0.0, "sleep_duration", sleep_duration, "more than 0");
  require(start_overlap >= 0.0, "start_overlap", start_overlap, "0 or more");
}

World::World(std::vector<RigidBody> shapes, const WorldSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(shapes), settings, nullptr,
                                   std::vector<GroundParameters>())) {}

World::World(std::vector<RigidBody> shapes, const WorldSettings& settings,
             const TerrainSurface& terrain, std::vector<GroundParameters> zones)
    : impl_(std::make_unique<Impl>(std::move(shapes), settings, &terrain, std::move(zones))) {}

World::~World() = default;
World::World(World&&) noexcept = default;

void World::observe(BodyObserver observer) { impl_->observer = std::move(observer); }

std::size_t World::add_body(std::size_t shape, const RigidState& state, bool fixed) {
  const std::string name = name_of_body(body_count());
  if (shape >= impl_->shapes.size()) {
    throw SimulationError(name + " has shape " + std::to_string(shape) + " but there are " +
                          std::to_string(impl_->shapes.size()));
  }
  if (!state.position.allFinite() || !state.velocity.allFinite() ||
      !state.angular_velocity.allFinite() ||
      !(std::abs(state.orientation.norm() - 1.0) < kUnitSlack)) {
    throw SimulationError(name +
                          ": position, velocity and spin must be finite and the orientation "
                          "a unit quaternion");
  }
  const Vec3& place = state.position;
  if (impl_->terrain && !fixed) {
    const std::optional<double> ground = impl_->terrain->height(place.x(), place.y(), place.z());
    if (!impl_->terrain->covers(place.x(), place.y())) {
      throw SimulationError(name + " starts at (" + with_digits(place.x(), 9) + ", " +
                            with_digits(place.y(), 9) +
                            "), which is not on the terrain; move it onto the ground");
    }
    if (ground && place.z() < *ground) {
      throw SimulationError(name + " starts below the ground, " +
                            with_digits(*ground - place.z(), 6) + " m deep; raise it");
    }
  }
  RigidState start = state;
  start.orientation.normalize();
  if (fixed) start.velocity = start.angular_velocity = Vec3::Zero();
  const WorldBody& body = impl_->bodies.emplace_back(impl_->shapes[shape], start, fixed);
  if (!fixed) impl_->initial += body.energy(impl_->settings.gravity);
  return body_count() - 1;
}

void World::step() { impl_->advance(impl_->settings.stiffness.time_step); }

StopReason World::run_until(double time) {
  const auto over = [&](const WorldBody& body) {
    return body.idle() || body.resting >= impl_->settings.rest_duration;
  };
  while (!std::all_of(impl_->bodies.begin(), impl_->bodies.end(), over)) {
    const double left = time - impl_->time;
    if (!(left > 0.0)) return StopReason::kMaxTime;
    impl_->advance(std::min(left, impl_->settings.stiffness.time_step));
  }
  const bool any_here = std::any_of(impl_->bodies.begin(), impl_->bodies.end(),
                                    [](const WorldBody& body) { return !body.still(); });
  return any_here ? StopReason::kRest : StopReason::kLeftTerrain;
}

double World::time() const { return impl_->time; }
std::size_t World::body_count() const { return impl_->bodies.size(); }
const RigidState& World::state(std::size_t body) const {
  return impl_->bodies.at(body).moving.state();
}
bool World::fixed(std::size_t body) const { return impl_->bodies.at(body).fixed; }
bool World::resting(std::size_t body) const {
  const WorldBody& asked = impl_->bodies.at(body);
  return asked.fixed || asked.asleep || asked.resting >= impl_->settings.rest_duration;
}
bool World::asleep(std::size_t body) const { return impl_->bodies.at(body).asleep; }
bool World::left_terrain(std::size_t body) const { return impl_->bodies.at(body).left; }
Vec3 World::contact_force(std::size_t body) const { return impl_->bodies.at(body).force; }

Touch World::touch(std::size_t body) const {
  return body < impl_->prepared ? impl_->touch(body) : Touch();
}

std::vector<std::size_t> World::touched_bodies(std::size_t body) const {
  std::vector<std::size_t> touched;
  if (body >= impl_->prepared) return touched;
  for (const std::uint32_t e : impl_->pairs.of(body)) {
    const ContactPair& pair = impl_->pairs.all()[e];
    if (pair.reference == kTerrain || !pair.contacts->touching()) continue;
    touched.push_back(pair.block == body ? pair.reference : pair.block);
  }
  std::sort(touched.begin(), touched.end());
  return touched;
}

double World::overlap(std::size_t body, std::size_t other) const {
  for (const ContactPair& pair : impl_->pairs.all()) {
    if ((pair.block == body && pair.reference == other) ||
        (pair.block == other && pair.reference == body)) {
      return pair.contacts->max_overlap();
    }
  }
  return 0.0;
}

Vec3 World::linear_momentum() const {
  Vec3 sum = Vec3::Zero();
  for (const WorldBody& body : impl_->bodies) {
    if (!body.fixed) sum += body.shape->body.mass * body.moving.state().velocity;
  }
  return sum;
}

Vec3 World::angular_momentum() const {
  Vec3 sum = Vec3::Zero();
  for (const WorldBody& body : impl_->bodies) {
    if (body.fixed) continue;
    const RigidState& state = body.moving.state();
    const RigidBody& rigid = body.shape->body;
    sum += state.position.cross(rigid.mass * state.velocity) +
           dem_detail::angular_momentum(rigid.moments, state.orientation, state.angular_velocity);
  }
  return sum;
}

EnergyLedger World::energy() const {
  EnergyLedger ledger = impl_->losses();
  ledger.initial = impl_->initial;
  // The potential counts from the heights at the end, so that the scale does not depend on the
  // datum.
  double datum = 0.0;
  for (const WorldBody& body : impl_->bodies) {
    if (body.fixed) continue;
    datum += body.shape->body.mass * impl_->settings.gravity * body.moving.state().position.z();
  }
  ledger.close(impl_->energy_now(), ledger.initial - datum);
  return ledger;
}

WorldStatistics World::statistics() const {
  WorldStatistics statistics;
  statistics.steps = impl_->steps;
  statistics.broad_phases = impl_->pairs.broad_phases();
  statistics.sleeping_bodies = impl_->sleeping.count();
  for (const WorldBody& body : impl_->bodies) statistics.pair_steps += body.pair_steps;
  for (const ContactPair& pair : impl_->pairs.all()) {
    ++statistics.near_pairs;
    if (pair.contacts->near()) ++statistics.searched_pairs;
    if (ContactPairs::active(pair, impl_->bodies)) ++statistics.active_pairs;
    if (pair.contacts->touching()) ++statistics.touching_pairs;
    statistics.contact_points += pair.contacts->contact_count();
    statistics.max_overlap = std::max(statistics.max_overlap, pair.contacts->max_overlap());
  }
  return statistics;
}

}  // namespace clast

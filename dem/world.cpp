#include "dem/world.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "dem/detail/body_pair.hpp"
#include "dem/detail/moving_body.hpp"
#include "dem/detail/near_pairs.hpp"
#include "dem/detail/rotation.hpp"
#include "dem/detail/terrain_impl.hpp"

namespace clast {
namespace {

/// Bounding spheres this far apart are listed, as a share of the mean radius of the bodies that
/// move: the list then lasts for tens of steps of a falling block.
constexpr double kSlackShare = 0.15;
/// Bodies and pairs handed to a thread at a time.
constexpr std::size_t kBodiesAtATime = 16;
constexpr std::size_t kPairsAtATime = 8;
/// The terrain's number in a pair of bodies.
constexpr std::uint32_t kTerrain = 0xffffffffu;
/// How far an orientation's norm may be from 1 before it is taken for a mistake.
constexpr double kUnitSlack = 1e-6;

/// A shape with what contacts need of it, once for all bodies that have it.
struct Shape {
  explicit Shape(RigidBody of_body)
      : body(std::move(of_body)),
        surface(indexed_surface(body.shape)),
        radius(body.bounding_radius()) {}
  RigidBody body;
  IndexedSurface surface;
  double radius;  ///< of the rounded body about its centre, m
};

struct Actor {
  Actor(const Shape& of_shape, const RigidState& start, bool is_fixed)
      : shape(&of_shape), moving(of_shape.body, start), fixed(is_fixed), motion(moving.motion()) {
    if (fixed) motion = without_motion();
  }
  BodyMotion without_motion() const {
    BodyMotion still;
    still.world_from_body = moving.state().world_from_body();
    return still;
  }
  bool still() const { return fixed || left; }

  const Shape* shape;
  MovingBody moving;
  bool fixed;
  bool left = false;
  bool off_terrain = false;  ///< found in the last step: about to leave
  BodyMotion motion;         ///< over the last step
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  double corrected = 0.0;        ///< energy that events inside the last step gave it, J
  double resting = 0.0;          ///< s
  std::uint64_t pair_steps = 0;  ///< touching pairs in which it is the block, summed over steps
};

/// Two bodies, or a body and the terrain, and their contacts.
struct Encounter {
  std::uint32_t ground;  ///< kTerrain, or the body that takes the ground's place
  std::uint32_t block;
  std::unique_ptr<BodyPair> contacts;

  NearPairs::Pair key() const { return {std::min(ground, block), std::max(ground, block)}; }
};

/// Adds what the events of one pair give to one of its bodies.
void add_event(std::optional<EventLoad>& sum, const EventLoad& event, bool is_block) {
  if (!sum) sum.emplace();
  sum->impulse += is_block ? event.impulse : Vec3(-event.impulse);
  sum->angular_impulse += is_block ? event.angular_impulse : event.angular_impulse_on_other;
  if (!is_block) return;  // only a block against what is fixed is shifted
  sum->moment += event.moment;
  sum->angular_moment += event.angular_moment;
}

std::string name_of_body(std::size_t body) { return "body " + std::to_string(body); }

}  // namespace

struct World::Impl {
  Impl(std::vector<RigidBody> bodies, const WorldSettings& with, const TerrainSurface* on,
       std::vector<GroundParameters> ground_zones)
      : settings(with), terrain(on), zones(std::move(ground_zones)), team(with.threads) {
    settings.check();
    for (const GroundParameters& zone : zones) zone.check("zone");
    if (terrain && zones.size() < terrain->zone_count()) {
      throw SimulationError("terrain has " + std::to_string(terrain->zone_count()) +
                            " ground zones but parameters are given for " +
                            std::to_string(zones.size()));
    }
    shapes.reserve(bodies.size());
    for (RigidBody& body : bodies) {
      body.check("shape " + std::to_string(shapes.size()));
      shapes.emplace_back(std::move(body));
    }
    between_bodies = {std::span(&settings.between_bodies, 1),
                      {},
                      settings.stiffness,
                      settings.weights,
                      settings.law};
    if (terrain) {
      on_terrain = {zones, terrain->impl().zones, settings.stiffness, settings.weights,
                    settings.law};
    }
  }

  void begin_moves(double dt);
  void find_near();
  void meet(double dt);
  bool takes_part(const Encounter& pair) const {
    return pair.block < prepared && (pair.ground == kTerrain || pair.ground < prepared);
  }
  void end_moves(double dt);
  void prepare();
  void take_out_what_left();
  void advance(double dt);
  /// What Verlet steps lose when they begin with these loads and no step has ended with them, J.
  double first_kick(const Actor& actor) const;
  double own_energy(const Actor& actor) const {
    return actor.moving.kinetic_energy() +
           actor.shape->body.mass * settings.gravity * actor.moving.state().position.z();
  }
  void refuse_deep_starts() const;
  Encounter encounter(std::uint32_t first, std::uint32_t second) const;
  const BodyMotion& motion_of(std::uint32_t body) const {
    return body == kTerrain ? still_ground : actors[body].motion;
  }
  EnergyLedger losses() const;
  double energy_now() const;

  WorldSettings settings;
  const TerrainSurface* terrain;
  std::vector<GroundParameters> zones;
  std::vector<Shape> shapes;
  BodyPair::Rules between_bodies, on_terrain;
  BodyMotion still_ground;
  ThreadTeam team;

  std::vector<Actor> actors;
  NearPairs near;
  double slack = 0.0;                 ///< of the list of near pairs, m
  std::vector<Encounter> encounters;  ///< first with the terrain by body, then sorted by pair
  std::vector<std::vector<std::uint32_t>> encounters_of;  ///< of every body, ascending
  std::vector<BoundingSphere> spheres;
  std::size_t prepared = 0;  ///< bodies that take part already

  double time = 0.0;
  double initial = 0.0;  ///< energy that bodies brought, J
  EnergyLedger parted;   ///< losses of pairs that are no more, and of no pair
  std::uint64_t steps = 0, lists_made = 0;
};

Encounter World::Impl::encounter(std::uint32_t first, std::uint32_t second) const {
  const Shape& a = *actors[first].shape;
  if (second == kTerrain) {
    return {kTerrain, first,
            std::make_unique<BodyPair>(terrain->impl().surface, a.surface, a.radius, a.body.size(),
                                       on_terrain)};
  }
  const Shape& b = *actors[second].shape;
  const double size = std::min(a.body.size(), b.body.size());
  if (takes_grounds_place(a.surface, a.radius, b.surface, b.radius)) {
    return {first, second,
            std::make_unique<BodyPair>(a.surface, b.surface, b.radius, size, between_bodies)};
  }
  return {second, first,
          std::make_unique<BodyPair>(b.surface, a.surface, a.radius, size, between_bodies)};
}

void World::Impl::begin_moves(double dt) {
  const Vec3 gravity(0.0, 0.0, -settings.gravity);
  team.run(actors.size(), kBodiesAtATime, [&](std::size_t i) {
    Actor& actor = actors[i];
    if (!actor.still()) {
      actor.motion = actor.moving.begin_step(dt, actor.force, actor.torque, gravity);
    }
  });
}

void World::Impl::find_near() {
  spheres.clear();
  for (const Actor& actor : actors) {
    spheres.push_back(
        {actor.motion.world_from_body.translation, actor.shape->radius, actor.still()});
  }
  if (!near.refresh(spheres, slack)) return;
  ++lists_made;

  std::vector<NearPairs::Pair> wanted;
  for (const NearPairs::Pair& pair : near.pairs()) {
    if (!actors[pair[0]].left && !actors[pair[1]].left) wanted.push_back(pair);
  }
  if (terrain) {
    for (std::uint32_t i = 0; i < actors.size(); ++i) {
      if (!actors[i].still()) wanted.push_back({i, kTerrain});
    }
    std::sort(wanted.begin(), wanted.end());
  }
  // Both lists are sorted: what is in both goes on, what is no longer near is closed.
  std::vector<Encounter> known = std::exchange(encounters, {});
  auto old = known.begin();
  const auto close_until = [&](const NearPairs::Pair& key) {
    for (; old != known.end() && old->key() < key; ++old) {
      old->contacts->part(motion_of(old->ground), motion_of(old->block));
      parted += old->contacts->ledger();
    }
  };
  for (const NearPairs::Pair& pair : wanted) {
    close_until(pair);
    if (old != known.end() && old->key() == pair) {
      encounters.push_back(std::move(*old++));
    } else {
      encounters.push_back(encounter(pair[0], pair[1]));
    }
  }
  close_until({kTerrain, kTerrain});
  encounters_of.assign(actors.size(), {});
  for (std::uint32_t e = 0; e < encounters.size(); ++e) {
    if (encounters[e].ground != kTerrain) encounters_of[encounters[e].ground].push_back(e);
    encounters_of[encounters[e].block].push_back(e);
  }
}

void World::Impl::meet(double dt) {
  find_near();
  team.run(encounters.size(), kPairsAtATime, [&](std::size_t e) {
    const Encounter& pair = encounters[e];
    pair.contacts->update(motion_of(pair.ground), motion_of(pair.block), dt);
  });
}

void World::Impl::end_moves(double dt) {
  const Vec3 gravity(0.0, 0.0, -settings.gravity);
  team.run(actors.size(), kBodiesAtATime, [&](std::size_t i) {
    Actor& actor = actors[i];
    actor.force = actor.torque = Vec3::Zero();
    actor.corrected = 0.0;
    std::uint64_t touching = 0, as_block = 0;
    std::optional<EventLoad> events;
    for (const std::uint32_t e : encounters_of[i]) {
      const Encounter& pair = encounters[e];
      const ContactLoad& load = pair.contacts->load();
      const bool is_block = pair.block == i;
      actor.force += is_block ? load.force : Vec3(-load.force);
      actor.torque += is_block ? load.torque : load.torque_on_other;
      if (load.event) add_event(events, *load.event, is_block);
      if (!pair.contacts->touching()) continue;
      ++touching;
      if (is_block) ++as_block;
    }
    if (actor.still()) return;
    actor.moving.end_step(dt, actor.force, actor.torque, gravity);
    if (events && dt > 0.0) {  // else they were given at the end of the step before
      actor.corrected = actor.moving.correct(events->impulse, events->angular_impulse,
                                             events->moment, events->angular_moment, gravity);
    }
    const double specific = actor.moving.kinetic_energy() / actor.shape->body.mass;
    actor.resting = touching > 0 && specific < settings.rest_energy ? actor.resting + dt : 0.0;
    actor.pair_steps += as_block;
    const Vec3& place = actor.moving.state().position;
    actor.off_terrain = terrain && !terrain->covers(place.x(), place.y());
  });
  for (const Actor& actor : actors) parted.reassigned -= actor.corrected;
}

double World::Impl::first_kick(const Actor& actor) const {
  if (actor.still() || (actor.force.isZero() && actor.torque.isZero())) return 0.0;
  const double dt = settings.stiffness.time_step, mass = actor.shape->body.mass;
  const Vec3 weight(0.0, 0.0, -mass * settings.gravity);
  const double push = (actor.force + weight).squaredNorm() - weight.squaredNorm();
  return 0.125 * dt * dt *
         (push / mass + actor.torque.dot(actor.moving.motion().turned_by(actor.torque)));
}

void World::Impl::prepare() {
  if (prepared == actors.size()) return;
  double radii = 0.0, moving = 0.0;
  for (const Actor& actor : actors) {
    if (actor.fixed) continue;
    radii += actor.shape->radius;
    moving += 1.0;
  }
  slack = kSlackShare * (moving > 0.0 ? radii / moving : 1.0);
  // Bodies that start in contact bring what is stored there.
  const double before = losses().reassigned;
  find_near();
  for (const Encounter& pair : encounters) {
    if (!takes_part(pair)) {
      pair.contacts->update(motion_of(pair.ground), motion_of(pair.block), 0.0);
    }
  }
  const double brought = losses().reassigned - before;
  parted.reassigned -= brought;
  initial -= brought;
  refuse_deep_starts();
  for (const Actor& actor : actors) parted.reassigned -= first_kick(actor);
  end_moves(0.0);
  for (const Actor& actor : actors) parted.reassigned += first_kick(actor);
  prepared = actors.size();
}

void World::Impl::refuse_deep_starts() const {
  for (const Encounter& pair : encounters) {
    if (takes_part(pair)) continue;
    const Shape& block = *actors[pair.block].shape;
    double size = block.body.size();
    if (pair.ground != kTerrain) size = std::min(size, actors[pair.ground].shape->body.size());
    const double overlap = pair.contacts->max_overlap();
    if (overlap <= settings.start_overlap * size) continue;
    const std::string other = pair.ground == kTerrain ? "the ground" : name_of_body(pair.ground);
    throw SimulationError(name_of_body(pair.block) + " starts inside " + other + ", " +
                          std::to_string(overlap) + " m deep; place it farther away");
  }
}

void World::Impl::take_out_what_left() {
  for (std::uint32_t i = 0; i < actors.size(); ++i) {
    Actor& actor = actors[i];
    if (actor.still() || !actor.off_terrain) continue;
    for (const std::uint32_t e : encounters_of[i]) {
      encounters[e].contacts->part(motion_of(encounters[e].ground), motion_of(encounters[e].block));
    }
    actor.left = true;
    actor.motion = actor.without_motion();
    near = {};
  }
}

EnergyLedger World::Impl::losses() const {
  EnergyLedger sum = parted;
  for (const Encounter& pair : encounters) sum += pair.contacts->ledger();
  return sum;
}

double World::Impl::energy_now() const {
  double sum = 0.0;
  for (const Actor& actor : actors) {
    if (actor.fixed) continue;
    sum += own_energy(actor);
  }
  for (const Encounter& pair : encounters) sum += pair.contacts->stored_energy();
  return sum;
}

void World::Impl::advance(double dt) {
  prepare();
  begin_moves(dt);
  meet(dt);
  end_moves(dt);
  time += dt;
  ++steps;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    if (!actors[i].moving.finite()) {
      throw SimulationError("the motion of " + name_of_body(i) + " is not finite any more at " +
                            std::to_string(time) + " s; a shorter time step may help");
    }
  }
  take_out_what_left();
}

void WorldSettings::check() const {
  ReleaseSettings same;
  same.stiffness = stiffness;
  same.gravity = gravity;
  same.rest_energy = rest_energy;
  same.rest_duration = rest_duration;
  same.check();
  between_bodies.check("between bodies");
  if (!(start_overlap >= 0.0)) {
    throw InputError("start_overlap = " + std::to_string(start_overlap) + "; must be 0 or more");
  }
}

World::World(std::vector<RigidBody> shapes, const WorldSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(shapes), settings, nullptr,
                                   std::vector<GroundParameters>())) {}

World::World(std::vector<RigidBody> shapes, const WorldSettings& settings,
             const TerrainSurface& terrain, std::vector<GroundParameters> zones)
    : impl_(std::make_unique<Impl>(std::move(shapes), settings, &terrain, std::move(zones))) {}

World::~World() = default;
World::World(World&&) noexcept = default;

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
      throw SimulationError(name + " starts at (" + std::to_string(place.x()) + ", " +
                            std::to_string(place.y()) + "), which is not on the terrain");
    }
    if (ground && place.z() < *ground) {
      throw SimulationError(name + " starts below the ground, " +
                            std::to_string(*ground - place.z()) + " m deep; raise it");
    }
  }
  RigidState start = state;
  start.orientation.normalize();
  if (fixed) start.velocity = start.angular_velocity = Vec3::Zero();
  const Actor& actor = impl_->actors.emplace_back(impl_->shapes[shape], start, fixed);
  if (!fixed) impl_->initial += impl_->own_energy(actor);
  return body_count() - 1;
}

void World::step() { impl_->advance(impl_->settings.stiffness.time_step); }

StopReason World::run_until(double time) {
  const auto over = [&](const Actor& actor) {
    return actor.still() || actor.resting >= impl_->settings.rest_duration;
  };
  while (!std::all_of(impl_->actors.begin(), impl_->actors.end(), over)) {
    const double left = time - impl_->time;
    if (!(left > 0.0)) return StopReason::kMaxTime;
    impl_->advance(std::min(left, impl_->settings.stiffness.time_step));
  }
  const bool any_here = std::any_of(impl_->actors.begin(), impl_->actors.end(),
                                    [](const Actor& actor) { return !actor.still(); });
  return any_here ? StopReason::kRest : StopReason::kLeftTerrain;
}

double World::time() const { return impl_->time; }
std::size_t World::body_count() const { return impl_->actors.size(); }
const RigidState& World::state(std::size_t body) const {
  return impl_->actors.at(body).moving.state();
}
const RigidBody& World::shape_of(std::size_t body) const {
  return impl_->actors.at(body).shape->body;
}
bool World::fixed(std::size_t body) const { return impl_->actors.at(body).fixed; }
bool World::resting(std::size_t body) const {
  const Actor& actor = impl_->actors.at(body);
  return actor.fixed || actor.resting >= impl_->settings.rest_duration;
}
bool World::left_terrain(std::size_t body) const { return impl_->actors.at(body).left; }
Vec3 World::contact_force(std::size_t body) const { return impl_->actors.at(body).force; }
Vec3 World::contact_torque(std::size_t body) const { return impl_->actors.at(body).torque; }

double World::overlap(std::size_t body, std::size_t other) const {
  for (const Encounter& pair : impl_->encounters) {
    if ((pair.block == body && pair.ground == other) ||
        (pair.block == other && pair.ground == body)) {
      return pair.contacts->max_overlap();
    }
  }
  return 0.0;
}

Vec3 World::linear_momentum() const {
  Vec3 sum = Vec3::Zero();
  for (const Actor& actor : impl_->actors) {
    if (!actor.fixed) sum += actor.shape->body.mass * actor.moving.state().velocity;
  }
  return sum;
}

Vec3 World::angular_momentum() const {
  Vec3 sum = Vec3::Zero();
  for (const Actor& actor : impl_->actors) {
    if (actor.fixed) continue;
    const RigidState& state = actor.moving.state();
    const RigidBody& body = actor.shape->body;
    sum += state.position.cross(body.mass * state.velocity) +
           clast::angular_momentum(body.moments, state.orientation, state.angular_velocity);
  }
  return sum;
}

EnergyLedger World::energy() const {
  EnergyLedger ledger = impl_->losses();
  ledger.initial = impl_->initial;
  // The potential counts from the heights at the end, so that the scale does not depend on the
  // datum.
  double datum = 0.0;
  for (const Actor& actor : impl_->actors) {
    if (actor.fixed) continue;
    datum += actor.shape->body.mass * impl_->settings.gravity * actor.moving.state().position.z();
  }
  ledger.close(impl_->energy_now(), ledger.initial - datum);
  return ledger;
}

WorldStatistics World::statistics() const {
  WorldStatistics statistics;
  statistics.steps = impl_->steps;
  statistics.lists_made = impl_->lists_made;
  for (const Actor& actor : impl_->actors) statistics.pair_steps += actor.pair_steps;
  for (const Encounter& pair : impl_->encounters) {
    ++statistics.near_pairs;
    if (pair.contacts->near()) ++statistics.searched_pairs;
    if (pair.contacts->touching()) ++statistics.touching_pairs;
    statistics.contact_points += pair.contacts->contact_count();
    statistics.max_overlap = std::max(statistics.max_overlap, pair.contacts->max_overlap());
  }
  return statistics;
}

}  // namespace clast

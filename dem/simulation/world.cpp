#include "dem/simulation/world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/byte_archive.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "dem/motion/rotation.hpp"
#include "dem/simulation/detail/world_motion.hpp"

namespace clast {

using namespace dem_detail;

namespace {

/// Largest difference of an orientation's norm from 1 that is accepted.
constexpr double kUnitSlack = 1e-6;

}  // namespace

struct World::Impl : WorldMotion {
  using WorldMotion::WorldMotion;
};

void WorldSettings::check() const {
  MotionSettings::check();
  between_bodies.check("between bodies");
  on_confining_walls.check("on forms");
  const auto require = [](bool fine, const char* name, double value, const char* range) {
    if (fine) return;
    throw InputError(std::string(name) + " = " + format_significant(value, 6) + "; must be " +
                     range);
  };
  require(sleep_drift >= 0.0, "sleep_drift", sleep_drift, "0 or more");
  require(sleep_duration > 0.0, "sleep_duration", sleep_duration, "more than 0");
}

World::World(std::vector<RigidBody> shapes, const WorldSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(shapes), settings, nullptr,
                                   std::vector<GroundParameters>())) {}

World::World(std::vector<RigidBody> shapes, const WorldSettings& settings,
             const TerrainSurface& terrain, std::vector<GroundParameters> zones)
    : impl_(std::make_unique<Impl>(std::move(shapes), settings, &terrain, std::move(zones))) {}

World::~World() = default;
World::World(World&&) noexcept = default;

void World::set_observer(BodyObserver observer) { impl_->set_observer(std::move(observer)); }

std::size_t World::add_body(std::size_t shape, const RigidState& state, bool fixed) {
  const std::string name = name_of_body(body_count());
  if (shape >= impl_->shapes().size()) {
    throw SimulationError(name + " has shape " + std::to_string(shape) + " but there are " +
                          std::to_string(impl_->shapes().size()));
  }
  if (!state.position.allFinite() || !state.velocity.allFinite() ||
      !state.angular_velocity.allFinite() ||
      !(std::abs(state.orientation.norm() - 1.0) < kUnitSlack)) {
    throw SimulationError(name +
                          ": position, velocity and spin must be finite and the orientation "
                          "a unit quaternion");
  }
  if (impl_->terrain() && !fixed) check_start_position(*impl_->terrain(), state.position, name);
  RigidState start = state;
  start.orientation.normalize();
  if (fixed) start.velocity = start.angular_velocity = Vec3::Zero();
  impl_->add_body(shape, start, fixed);
  return body_count() - 1;
}

std::size_t World::add_confining_wall(std::size_t shape, const RigidState& state, std::size_t first,
                                      std::size_t end) {
  const std::size_t wall = add_body(shape, state, true);
  impl_->set_confined_bodies(wall, {first, end});
  return wall;
}

void World::remove_body(std::size_t body) {
  if (body >= body_count()) {
    throw SimulationError("there is no " + name_of_body(body) + " to remove, only " +
                          std::to_string(body_count()) + " bodies");
  }
  impl_->remove_body(body);
}

void World::release_bodies(std::span<const std::size_t> bodies) {
  for (const std::size_t body : bodies) {
    const std::string name = name_of_body(body);
    if (body >= body_count()) {
      throw SimulationError("there is no " + name + " to free, only " +
                            std::to_string(body_count()) + " bodies");
    }
    if (!is_fixed(body) || is_inactive(body)) {
      throw SimulationError(name + (is_inactive(body) ? " is gone" : " moves already") +
                            "; only existing fixed bodies can be made free");
    }
    if (impl_->terrain()) check_start_position(*impl_->terrain(), state(body).position, name);
  }
  impl_->release_bodies(bodies);
}

void World::step() { impl_->advance(1e300); }

StopReason World::run_until_rest(double time, const std::function<void()>& after_step) {
  const std::vector<WorldBody>& bodies = impl_->bodies();
  const auto all_rest = [&] {
    const std::span<const std::uint32_t> moving = impl_->moving_bodies();
    return std::all_of(moving.begin(), moving.end(),
                       [&](std::uint32_t i) { return impl_->is_resting(bodies[i]); });
  };
  while (!all_rest()) {
    const double left = time - impl_->time();
    if (!(left > 0.0)) return StopReason::kMaxTime;
    impl_->advance(left);
    if (after_step) after_step();
  }
  const bool any_here = std::any_of(bodies.begin(), bodies.end(),
                                    [](const WorldBody& body) { return !body.is_immobile(); });
  return any_here ? StopReason::kRest : StopReason::kLeftTerrain;
}

void World::run_to_time(double time, const std::function<void()>& after_step) {
  for (double left; (left = time - impl_->time()) > 0.0;) {
    if (impl_->moving_bodies().empty()) {
      impl_->advance_time(left);
    } else {
      impl_->advance(left);
    }
    if (after_step) after_step();
  }
}

double World::time() const { return impl_->time(); }
std::size_t World::body_count() const { return impl_->bodies().size(); }
const RigidState& World::state(std::size_t body) const {
  return impl_->bodies().at(body).integrator.state();
}
bool World::is_fixed(std::size_t body) const { return impl_->bodies().at(body).fixed; }
bool World::is_resting(std::size_t body) const {
  const WorldBody& asked = impl_->bodies().at(body);
  return asked.fixed || asked.asleep || asked.resting_time >= impl_->settings().rest_duration;
}
bool World::is_asleep(std::size_t body) const { return impl_->bodies().at(body).asleep; }
bool World::is_inactive(std::size_t body) const { return impl_->bodies().at(body).inactive; }
bool World::has_left_terrain(std::size_t body) const {
  const WorldBody& asked = impl_->bodies().at(body);
  return asked.inactive && asked.off_terrain;
}
Vec3 World::contact_force(std::size_t body) const { return impl_->bodies().at(body).force; }
ContactSummary World::contact_summary(std::size_t body) const {
  return impl_->contact_summary(body);
}

std::vector<std::size_t> World::touching_bodies(std::size_t body) const {
  std::vector<std::size_t> touched;
  if (!impl_->is_prepared(body)) return touched;
  for (const std::uint32_t e : impl_->pairs().pairs_of(body)) {
    const ContactPair& pair = impl_->pairs().all_pairs()[e];
    if (!pair.has_load || pair.reference == ContactPair::kTerrain ||
        !pair.contacts->is_touching()) {
      continue;
    }
    touched.push_back(pair.block == body ? pair.reference : pair.block);
  }
  std::sort(touched.begin(), touched.end());
  return touched;
}

double World::overlap(std::size_t body, std::size_t other) const {
  for (const ContactPair& pair : impl_->pairs().all_pairs()) {
    if ((pair.block == body && pair.reference == other) ||
        (pair.block == other && pair.reference == body)) {
      return pair.contacts->max_overlap();
    }
  }
  return 0.0;
}

Vec3 World::linear_momentum() const {
  Vec3 sum = Vec3::Zero();
  for (const WorldBody& body : impl_->bodies()) {
    if (!body.fixed) sum += body.shape->body.mass * body.integrator.state().velocity;
  }
  return sum;
}

Vec3 World::angular_momentum() const {
  Vec3 sum = Vec3::Zero();
  for (const WorldBody& body : impl_->bodies()) {
    if (body.fixed) continue;
    const RigidState& state = body.integrator.state();
    const RigidBody& rigid = body.shape->body;
    sum += state.position.cross(rigid.mass * state.velocity) +
           dem_detail::angular_momentum(rigid.moments, state.orientation, state.angular_velocity);
  }
  return sum;
}

EnergyBalance World::energy_balance() const { return impl_->energy_balance(); }
EnergySample World::energy_sample() const { return impl_->energy_sample(); }

WorldStatistics World::statistics() const {
  WorldStatistics statistics;
  statistics.steps = impl_->step_count();
  statistics.broad_phase_count = impl_->pairs().broad_phase_count();
  statistics.sleeping_bodies = impl_->sleeping_count();
  for (const WorldBody& body : impl_->bodies()) statistics.pair_steps += body.pair_steps;
  for (const ContactPair& pair : impl_->pairs().all_pairs()) {
    ++statistics.near_pairs;
    if (pair.contacts->has_narrow_phase()) ++statistics.searched_pairs;
    if (ContactPairTable::is_active(pair, impl_->bodies())) ++statistics.active_pairs;
    if (pair.contacts->is_touching()) ++statistics.touching_pairs;
    statistics.contact_points += pair.contacts->contact_count();
    statistics.max_overlap = std::max(statistics.max_overlap, pair.contacts->max_overlap());
  }
  return statistics;
}

void World::save(ByteWriter& to) const { to(*impl_); }
void World::restore(ByteReader& from) { from(*impl_); }

}  // namespace clast

#include "dem/simulation/detail/time_step.hpp"

#include <algorithm>
#include <cmath>

#include "dem/motion/free_flight.hpp"

namespace clast::dem_detail {
namespace {

/// @param energy  energy transferred by the contact, J
bool in_impact(const WorldBody& body, double energy, double rest_energy) {
  if (body.is_idle()) return false;
  const double floor = kRockingEnergyFactor * rest_energy * body.shape->body.mass;
  return is_impact(energy, std::max(body.integrator.kinetic_energy(), floor));
}

/// Returns the mobility of a body at its contacts, 1/kg: with springs of stiffness k there, no
/// frequency exceeds sqrt(k mobility). A spring between two moving bodies counts twice.
double mobility_of(std::uint32_t index, std::span<const WorldBody> bodies,
                   const ContactPairTable& pairs) {
  const BodyShape& shape = *bodies[index].shape;
  double sum = 0.0;
  for (const std::uint32_t e : pairs.pairs_of(index)) {
    const ContactPair& pair = pairs.all_pairs()[e];
    if (!pair.contacts->is_touching()) continue;
    const bool is_block = pair.block == index;
    const std::uint32_t other = is_block ? pair.reference : pair.block;
    const double ends = other == ContactPair::kTerrain || bodies[other].is_idle() ? 1.0 : 2.0;
    sum += ends * (is_block ? pair.contacts->contact_mobility(shape.mobilities)
                            : pair.contacts->weight() * shape.largest_mobility);
  }
  return sum;
}

/// Returns a lower bound of the time until a pair without contact can touch, s.
double time_apart(const ContactPair& pair, std::span<const WorldBody> bodies,
                  const ContactPairTable& pairs, double gravity) {
  const WorldBody& block = bodies[pair.block];
  const double clear = pairs.clearance(pair, bodies);
  if (!(clear > 0.0)) return 0.0;
  Vec3 velocity = block.is_idle() ? Vec3::Zero() : block.integrator.state().velocity;
  double turning =
      block.is_idle() ? 0.0 : block.integrator.max_angular_speed() * block.shape->radius;
  if (pair.reference != ContactPair::kTerrain && !bodies[pair.reference].is_idle()) {
    const RigidBodyIntegrator& reference = bodies[pair.reference].integrator;
    velocity -= reference.state().velocity;
    // In the frame of a rotating reference body, the block rotates about it.
    const double arm = (block.integrator.state().position - reference.state().position).norm();
    turning += reference.max_angular_speed() * (arm + block.shape->radius);
  }
  return min_travel_time(clear, velocity.norm() + turning, gravity);
}

}  // namespace

double contact_time_step(const ContactStiffness& contact, double mobility_ratio, bool impact) {
  const double together =
      contact.max_time_step * std::min(1.0 / std::sqrt(mobility_ratio), kMaxStepGrowth);
  return impact ? std::min(contact.time_step, together) : together;
}

TimeStep choose_time_step(std::span<const WorldBody> bodies, std::span<const std::uint32_t> moving,
                          const ContactPairTable& pairs, const WorldSettings& settings) {
  const ContactStiffness& contact = settings.stiffness;
  const TimeStep shortest{contact.time_step, false};
  if (!allows_longer_steps(contact)) return shortest;
  bool touching = false;
  for (const std::uint32_t e : pairs.active_pairs()) {
    const ContactPair& pair = pairs.all_pairs()[e];
    if (!pair.has_load || !pair.contacts->is_touching()) continue;
    touching = true;
    const WorldBody& block = bodies[pair.block];
    const double energy = pair.contacts->load().impact_energy * block.shape->body.mass;
    if (in_impact(block, energy, settings.rest_energy) ||
        (pair.reference != ContactPair::kTerrain &&
         in_impact(bodies[pair.reference], energy, settings.rest_energy))) {
      return shortest;
    }
  }
  double length = touching ? kMaxStepGrowth * contact.max_time_step : 1e300;
  for (const std::uint32_t i : moving) {
    const WorldBody& body = bodies[i];
    const double mobility_ratio = mobility_of(i, bodies, pairs) / body.shape->largest_mobility;
    if (mobility_ratio > 0.0)
      length = std::min(length, contact.max_time_step / std::sqrt(mobility_ratio));
    if (touching) continue;
    length = std::min(
        length, min_travel_time(pairs.remaining_displacement(i, body.integrator.state().position),
                                body.integrator.state().velocity.norm(), settings.gravity));
  }
  for (const std::uint32_t e : pairs.active_pairs()) {
    const ContactPair& pair = pairs.all_pairs()[e];
    if (length <= contact.time_step) return shortest;
    if (pair.contacts->is_touching()) continue;
    length = std::min(length, time_apart(pair, bodies, pairs, settings.gravity));
  }
  if (length <= contact.time_step || length >= 1e300) return shortest;
  return {length, !touching};
}

}  // namespace clast::dem_detail

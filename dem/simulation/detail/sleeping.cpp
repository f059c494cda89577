#include "dem/simulation/detail/sleeping.hpp"

#include <algorithm>
#include <vector>

namespace clast::dem_detail {

namespace {

/// True if the pair consists of two touching bodies; false for a body on the terrain.
bool bodies_touch(const ContactPair& pair) {
  return pair.has_load && pair.reference != ContactPair::kTerrain && pair.contacts->is_touching();
}

std::uint32_t other_of(const ContactPair& pair, std::uint32_t body) {
  return pair.block == body ? pair.reference : pair.block;
}

bool is_stationary(const WorldBody& body) {
  return body.is_idle() || body.sleep_detector.is_stationary();
}

bool is_among_staying(std::uint32_t body, std::span<const WorldBody> bodies,
                      const ContactPairTable& pairs) {
  const std::span<const std::uint32_t> around = pairs.pairs_of(body);
  return std::all_of(around.begin(), around.end(), [&](std::uint32_t e) {
    const ContactPair& pair = pairs.all_pairs()[e];
    return !bodies_touch(pair) || is_stationary(bodies[other_of(pair, body)]);
  });
}

/// @return  removed kinetic energy, J
double put_body_to_sleep(std::uint32_t index, std::span<WorldBody> bodies,
                         const ContactPairTable& pairs) {
  WorldBody& body = bodies[index];
  const double energy = body.integrator.kinetic_energy();
  RigidState state = body.integrator.state();
  state.velocity = state.angular_velocity = Vec3::Zero();
  body.integrator.set_state(state);
  body.apply_motion(body.integrator.current_motion());
  body.asleep = true;
  for (const std::uint32_t e : pairs.pairs_of(index))
    pairs.all_pairs()[e].contacts->clear_correction_impulse();
  return energy;
}

}  // namespace

void SleepManager::wake_touched(std::span<WorldBody> bodies, const ContactPairTable& pairs) {
  if (count_ == 0) return;
  for (const std::uint32_t e : pairs.active_pairs()) {
    const ContactPair& pair = pairs.all_pairs()[e];
    if (!bodies_touch(pair)) continue;
    const WorldBody &block = bodies[pair.block], &reference = bodies[pair.reference];
    if (block.asleep && !is_stationary(reference)) wake(pair.block, bodies, pairs);
    if (reference.asleep && !is_stationary(block)) wake(pair.reference, bodies, pairs);
  }
}

void SleepManager::wake_around(std::uint32_t body, std::span<WorldBody> bodies,
                               const ContactPairTable& pairs) {
  wake(body, bodies, pairs);
  for (const std::uint32_t e : pairs.pairs_of(body)) {
    const ContactPair& pair = pairs.all_pairs()[e];
    if (!bodies_touch(pair)) continue;
    const std::uint32_t other = other_of(pair, body);
    wake(other, bodies, pairs);
    // A body that is awake may have rested on it, too.
    bodies[other].resting_time = 0.0;
    bodies[other].sleep_detector.reset();
  }
}

void SleepManager::wake(std::uint32_t body, std::span<WorldBody> bodies,
                        const ContactPairTable& pairs) {
  std::vector<std::uint32_t> waking = {body};
  while (!waking.empty()) {
    const std::uint32_t index = waking.back();
    waking.pop_back();
    WorldBody& woken = bodies[index];
    if (!woken.asleep) continue;
    woken.asleep = false;
    woken.resting_time = 0.0;
    woken.sleep_detector.reset();
    --count_;
    for (const std::uint32_t e : pairs.pairs_of(index)) {
      const ContactPair& pair = pairs.all_pairs()[e];
      if (bodies_touch(pair)) waking.push_back(other_of(pair, index));
    }
  }
}

double SleepManager::put_to_sleep(std::span<WorldBody> bodies,
                                  std::span<const std::uint32_t> moving,
                                  const ContactPairTable& pairs) {
  double energy = 0.0;
  for (const std::uint32_t i : moving) {
    if (bodies[i].is_idle() || !bodies[i].sleep_detector.is_stationary() ||
        !is_among_staying(i, bodies, pairs)) {
      continue;
    }
    energy += put_body_to_sleep(i, bodies, pairs);
    ++count_;
  }
  return energy;
}

}  // namespace clast::dem_detail

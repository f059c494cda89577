#include "dem/simulation/detail/sleeping.hpp"

#include <algorithm>
#include <vector>

namespace clast::dem_detail {

namespace {

/// Two bodies that touch; a body that touches the terrain is none.
bool bodies_touch(const ContactPair& pair) {
  return pair.loads && pair.reference != ContactPair::kTerrain && pair.contacts->touching();
}

std::uint32_t other_of(const ContactPair& pair, std::uint32_t body) {
  return pair.block == body ? pair.reference : pair.block;
}

bool stays(const WorldBody& body) { return body.idle() || body.watch.stays(); }

bool is_among_staying(std::uint32_t body, std::span<const WorldBody> bodies,
                      const ContactPairs& pairs) {
  const std::span<const std::uint32_t> around = pairs.of(body);
  return std::all_of(around.begin(), around.end(), [&](std::uint32_t e) {
    const ContactPair& pair = pairs.all()[e];
    return !bodies_touch(pair) || stays(bodies[other_of(pair, body)]);
  });
}

/// @return  the kinetic energy that is gone, J
double put_to_sleep(std::uint32_t number, std::span<WorldBody> bodies, const ContactPairs& pairs) {
  WorldBody& body = bodies[number];
  const double energy = body.moving.kinetic_energy();
  RigidState state = body.moving.state();
  state.velocity = state.angular_velocity = Vec3::Zero();
  body.moving.place(state);
  body.move(body.moving.motion());
  body.asleep = true;
  for (const std::uint32_t e : pairs.of(number)) pairs.all()[e].contacts->drop_event();
  return energy;
}

}  // namespace

void Sleeping::wake_touched(std::span<WorldBody> bodies, const ContactPairs& pairs) {
  if (count_ == 0) return;
  for (const std::uint32_t e : pairs.active()) {
    const ContactPair& pair = pairs.all()[e];
    if (!bodies_touch(pair)) continue;
    const WorldBody &block = bodies[pair.block], &reference = bodies[pair.reference];
    if (block.asleep && !stays(reference)) wake(pair.block, bodies, pairs);
    if (reference.asleep && !stays(block)) wake(pair.reference, bodies, pairs);
  }
}

void Sleeping::wake_around(std::uint32_t body, std::span<WorldBody> bodies,
                           const ContactPairs& pairs) {
  wake(body, bodies, pairs);
  for (const std::uint32_t e : pairs.of(body)) {
    const ContactPair& pair = pairs.all()[e];
    if (!bodies_touch(pair)) continue;
    const std::uint32_t other = other_of(pair, body);
    wake(other, bodies, pairs);
    // Also one that is awake may have rested on it.
    bodies[other].resting = 0.0;
    bodies[other].watch.reset();
  }
}

void Sleeping::wake(std::uint32_t body, std::span<WorldBody> bodies, const ContactPairs& pairs) {
  std::vector<std::uint32_t> waking = {body};
  while (!waking.empty()) {
    const std::uint32_t number = waking.back();
    waking.pop_back();
    WorldBody& woken = bodies[number];
    if (!woken.asleep) continue;
    woken.asleep = false;
    woken.resting = 0.0;
    woken.watch.reset();
    --count_;
    for (const std::uint32_t e : pairs.of(number)) {
      const ContactPair& pair = pairs.all()[e];
      if (bodies_touch(pair)) waking.push_back(other_of(pair, number));
    }
  }
}

double Sleeping::let_sleep(std::span<WorldBody> bodies, std::span<const std::uint32_t> moving,
                           const ContactPairs& pairs) {
  double energy = 0.0;
  for (const std::uint32_t i : moving) {
    if (bodies[i].idle() || !bodies[i].watch.stays() || !is_among_staying(i, bodies, pairs)) {
      continue;
    }
    energy += put_to_sleep(i, bodies, pairs);
    ++count_;
  }
  return energy;
}

}  // namespace clast::dem_detail

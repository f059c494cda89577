#pragma once
/// Realisations of boxes that stay, with energies that are easy to add up.
#include "tests/study/boxes_that_stay.hpp"

namespace clast {

/// Of both realisations 1,000 J become 500 J of motion half way and are dissipated at the end: 0.4
/// by friction and 0.2 by normal forces on the ground, 0.3 by friction and 0.1 by rolling between
/// blocks. The first takes 4 s, the second 8 s.
inline CampaignResults energies_that_are_lost() {
  CampaignResults results = boxes_that_stay();
  for (std::uint32_t realisation = 0; realisation < 2; ++realisation) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      EnergySample sample;
      sample.time = 2.0 * i * (realisation + 1);
      sample.moving = i == 2 ? 0 : 3;
      sample.potential = 1500.0 - 500.0 * i;
      if (i == 1) {
        sample.translational = 300.0;
        sample.rotational = 200.0;
      }
      if (i == 2) {
        sample.on_ground = {.normal = 200.0, .friction = 400.0};
        sample.between_bodies = {.friction = 300.0, .rolling = 100.0};
      }
      results.energies.push_back({3 * realisation, sample});
    }
  }
  return results;
}

}  // namespace clast

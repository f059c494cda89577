#pragma once
/// Bit-for-bit comparison of what results files hold.
#include <gtest/gtest.h>

#include "study/results/results.hpp"

namespace clast {

inline void expect_equal(const RigidState& a, const RigidState& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.orientation.coeffs(), b.orientation.coeffs());
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.angular_velocity, b.angular_velocity);
}

inline void expect_equal(const Crossing& a, const Crossing& b) {
  EXPECT_EQ(a.run, b.run);
  EXPECT_EQ(a.barrier, b.barrier);
  EXPECT_EQ(a.forward, b.forward);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.angular_velocity, b.angular_velocity);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.clearance, b.clearance);
  EXPECT_EQ(a.translational_energy, b.translational_energy);
  EXPECT_EQ(a.rotational_energy, b.rotational_energy);
}

inline void expect_equal(const Impact& a, const Impact& b) {
  EXPECT_EQ(a.run, b.run);
  EXPECT_EQ(a.zone, b.zone);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.contact_duration, b.contact_duration);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.speed_before, b.speed_before);
  EXPECT_EQ(a.speed_after, b.speed_after);
  EXPECT_EQ(a.translational_before, b.translational_before);
  EXPECT_EQ(a.translational_after, b.translational_after);
  EXPECT_EQ(a.rotational_before, b.rotational_before);
  EXPECT_EQ(a.rotational_after, b.rotational_after);
  EXPECT_EQ(a.depth, b.depth);
}

inline void expect_equal(const RunRecord& a, const RunRecord& b) {
  EXPECT_EQ(a.run, b.run);
  EXPECT_EQ(a.block, b.block);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.orientation, b.orientation);
  EXPECT_EQ(a.ground_set, b.ground_set);
  EXPECT_EQ(a.contacts.contact_time, b.contacts.contact_time);
  EXPECT_EQ(a.contacts.mean_contact_points, b.contacts.mean_contact_points);
  EXPECT_EQ(a.contacts.max_contact_points, b.contacts.max_contact_points);
  EXPECT_EQ(a.contacts.longest_flight, b.contacts.longest_flight);
  EXPECT_EQ(a.contacts.max_energy, b.contacts.max_energy);
  EXPECT_EQ(a.contacts.max_spin, b.contacts.max_spin);
  expect_equal(a.start, b.start);
  EXPECT_EQ(a.stiffness.normal, b.stiffness.normal);
  EXPECT_EQ(a.stiffness.tangential, b.stiffness.tangential);
  EXPECT_EQ(a.stiffness.rolling, b.stiffness.rolling);
  EXPECT_EQ(a.stiffness.time_step, b.stiffness.time_step);
  EXPECT_EQ(a.settled_depth, b.settled_depth);
  EXPECT_EQ(a.impact_depth, b.impact_depth);
  const ReleaseResult &x = a.result, &y = b.result;
  EXPECT_EQ(x.stop_reason, y.stop_reason);
  EXPECT_EQ(x.message, y.message);
  EXPECT_EQ(x.duration, y.duration);
  expect_equal(x.final_state, y.final_state);
  EXPECT_EQ(x.path_length, y.path_length);
  EXPECT_EQ(x.max_speed, y.max_speed);
  EXPECT_EQ(x.max_penetration, y.max_penetration);
  EXPECT_EQ(x.settled_penetration, y.settled_penetration);
  EXPECT_EQ(x.below_ground, y.below_ground);
  EXPECT_EQ(x.energy.initial, y.energy.initial);
  EXPECT_EQ(x.energy.final, y.energy.final);
  EXPECT_EQ(x.energy.normal, y.energy.normal);
  EXPECT_EQ(x.energy.friction, y.energy.friction);
  EXPECT_EQ(x.energy.rolling, y.energy.rolling);
  EXPECT_EQ(x.energy.reassigned, y.energy.reassigned);
  EXPECT_EQ(x.energy.error, y.energy.error);
  EXPECT_EQ(x.contact_steps, y.contact_steps);
  EXPECT_EQ(x.impacts, y.impacts);
}

inline void expect_equal_energies(const CampaignResults& a, const CampaignResults& b) {
  ASSERT_EQ(a.energies.size(), b.energies.size());
  for (std::size_t i = 0; i < a.energies.size(); ++i) {
    const EnergySample &x = a.energies[i].energy, &y = b.energies[i].energy;
    EXPECT_EQ(a.energies[i].run, b.energies[i].run);
    EXPECT_EQ(x.time, y.time);
    EXPECT_EQ(x.moving, y.moving);
    EXPECT_EQ(x.translational, y.translational);
    EXPECT_EQ(x.rotational, y.rotational);
    EXPECT_EQ(x.potential, y.potential);
    EXPECT_EQ(x.stored, y.stored);
    EXPECT_EQ(x.departed, y.departed);
    for (const auto place : {&EnergySample::on_ground, &EnergySample::between_bodies}) {
      EXPECT_EQ((x.*place).normal, (y.*place).normal);
      EXPECT_EQ((x.*place).friction, (y.*place).friction);
      EXPECT_EQ((x.*place).rolling, (y.*place).rolling);
    }
    EXPECT_EQ(x.reassigned, y.reassigned);
  }
}

inline void expect_equal(const Trajectory& a, const Trajectory& b) {
  EXPECT_EQ(a.time, b.time);
  ASSERT_EQ(a.states.size(), b.states.size());
  for (std::size_t i = 0; i < a.states.size(); ++i) expect_equal(a.states[i], b.states[i]);
}

/// Runs, crossings and trajectories of both files. Not the bytes of the files: HDF5 writes times.
inline void expect_equal_results(const std::filesystem::path& one,
                                 const std::filesystem::path& other) {
  const CampaignResults a = read_results(one), b = read_results(other);
  ASSERT_EQ(a.runs.size(), b.runs.size());
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    expect_equal(a.runs[i], b.runs[i]);
    expect_equal(read_trajectory(one, a.runs[i].run), read_trajectory(other, b.runs[i].run));
  }
  ASSERT_EQ(a.crossings.size(), b.crossings.size());
  for (std::size_t i = 0; i < a.crossings.size(); ++i) {
    expect_equal(a.crossings[i], b.crossings[i]);
  }
  ASSERT_EQ(a.impacts.size(), b.impacts.size());
  for (std::size_t i = 0; i < a.impacts.size(); ++i) expect_equal(a.impacts[i], b.impacts[i]);
}

}  // namespace clast

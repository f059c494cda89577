#pragma once
/// Layout of the datasets of a results file, declared once for the file, its journal, tables and
/// docs/formats.md.
///
/// `visit_columns` calls visit(name, unit, meaning, field) for each column, in the order of file
/// and journal. `std::invoke(field, row)` returns an assignable reference to the value in a row.
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>

#include "study/results/results.hpp"

namespace clast::study_detail {

inline constexpr const char* kResultsFormat = "clast results";
inline constexpr int kResultsSchema = 4;
inline constexpr int kOldestResultsSchema = 2;  ///< oldest schema that can be read

/// Converts a value to the type that its dataset stores.
inline std::uint32_t to_stored_value(std::uint32_t value) { return value; }
inline double to_stored_value(double value) { return value; }
inline std::string to_stored_value(const std::string& value) { return value; }
inline std::int64_t to_stored_value(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}
inline std::uint8_t to_stored_value(bool value) { return value ? 1 : 0; }
inline std::uint8_t to_stored_value(StopReason value) { return static_cast<std::uint8_t>(value); }
template <class Row, class Field>
using StoredType =
    decltype(to_stored_value(std::invoke(std::declval<Field>(), std::declval<const Row&>())));

template <class Row>
inline constexpr std::type_identity<Row> kRowType{};

/// Calls `visit` for each column of a rigid-body state: position, orientation and velocities.
template <class Visit>
void visit_columns(std::type_identity<RigidState>, const Visit& visit) {
  const char* place = "position of the centre of mass";
  const char* turn = "orientation (world from principal frame)";
  const char* velocity = "velocity of the centre of mass";
  const char* spin = "angular velocity along the world axes";
  visit("x_m", "m", place, [](auto& s) -> decltype(auto) { return (s.position.x()); });
  visit("y_m", "m", place, [](auto& s) -> decltype(auto) { return (s.position.y()); });
  visit("z_m", "m", place, [](auto& s) -> decltype(auto) { return (s.position.z()); });
  visit("qw", "", turn, [](auto& s) -> decltype(auto) { return (s.orientation.w()); });
  visit("qx", "", turn, [](auto& s) -> decltype(auto) { return (s.orientation.x()); });
  visit("qy", "", turn, [](auto& s) -> decltype(auto) { return (s.orientation.y()); });
  visit("qz", "", turn, [](auto& s) -> decltype(auto) { return (s.orientation.z()); });
  visit("vx_m_s", "m/s", velocity, [](auto& s) -> decltype(auto) { return (s.velocity.x()); });
  visit("vy_m_s", "m/s", velocity, [](auto& s) -> decltype(auto) { return (s.velocity.y()); });
  visit("vz_m_s", "m/s", velocity, [](auto& s) -> decltype(auto) { return (s.velocity.z()); });
  visit("wx_rad_s", "rad/s", spin,
        [](auto& s) -> decltype(auto) { return (s.angular_velocity.x()); });
  visit("wy_rad_s", "rad/s", spin,
        [](auto& s) -> decltype(auto) { return (s.angular_velocity.y()); });
  visit("wz_rad_s", "rad/s", spin,
        [](auto& s) -> decltype(auto) { return (s.angular_velocity.z()); });
}

/// Calls `visit` for the columns of contact stiffness, time step and depths of a run.
template <class Visit>
void visit_stiffness(const Visit& visit) {
  const char* used = "k_n and k_t as used, determined for the run or given";
  visit("stiffness_n_m", "N/m", used,
        [](auto& r) -> decltype(auto) { return (r.stiffness.normal); });
  visit("tangential_stiffness_n_m", "N/m", used,
        [](auto& r) -> decltype(auto) { return (r.stiffness.tangential); });
  visit("rolling_stiffness_n_m_rad", "N m/rad",
        "k_r on zones without a rolling length, determined for the run or "
        "given; on zones with a rolling length a it is k_n a^2",
        [](auto& r) -> decltype(auto) { return (r.stiffness.rolling); });
  visit("time_step_s", "s", "time step of impacts as used, determined for the run or given",
        [](auto& r) -> decltype(auto) { return (r.stiffness.time_step); });
  visit("rest_depth_m", "m",
        "settled depth of the block under its k_n, on the ground zone with the least "
        "support; since schema 4",
        &RunRecord::settled_depth);
  visit("impact_depth_m", "m",
        "penetration depth of an impact at the highest speed that its start allows; since schema 4",
        &RunRecord::impact_depth);
}

/// Calls `visit` for the columns of the start or final state of a run.
/// @param prefix  prefix of the column names
/// @param when  suffix of the column descriptions, such as " at the start"
/// @param state  function that returns the state of a run
template <class Visit, class State>
void visit_state(const Visit& visit, const std::string& prefix, const std::string& when,
                 const State& state) {
  visit_columns(kRowType<RigidState>, [&](const std::string& name, const char* unit,
                                          const std::string& meaning, const auto& field) {
    visit(prefix + name, unit, meaning + when,
          [state, field](auto& run) -> decltype(auto) { return (field(state(run))); });
  });
}

template <class Visit>
void visit_energies(const Visit& visit) {
  visit("energy_initial_j", "J", "kinetic, potential and stored energy at the start",
        [](auto& r) -> decltype(auto) { return (r.result.energy.initial); });
  visit("energy_final_j", "J", "kinetic, potential and stored energy at the end",
        [](auto& r) -> decltype(auto) { return (r.result.energy.final); });
  visit("energy_normal_j", "J", "energy dissipated by the normal law",
        [](auto& r) -> decltype(auto) { return (r.result.energy.normal); });
  visit("energy_friction_j", "J", "energy dissipated by sliding and by scar drag",
        [](auto& r) -> decltype(auto) { return (r.result.energy.friction); });
  visit("energy_rolling_j", "J", "energy dissipated by rolling resistance",
        [](auto& r) -> decltype(auto) { return (r.result.energy.rolling); });
  visit("energy_reassigned_j", "J",
        "energy lost (negative: gained) when contacts or their weights change",
        [](auto& r) -> decltype(auto) { return (r.result.energy.reassigned); });
  visit("energy_error", "", "error of the energy balance, as a fraction of the dissipated energy",
        [](auto& r) -> decltype(auto) { return (r.result.energy.error); });
}

template <class Visit>
void visit_columns(std::type_identity<RunRecord>, const Visit& visit) {
  visit("run", "", "number of the run in its campaign, from 0", &RunRecord::run);
  visit("block", "", "row of `/blocks`", &RunRecord::block);
  visit("point", "", "index of the release point, from 0", &RunRecord::point);
  visit("orientation", "", "index of the orientation in its release set, from 0",
        &RunRecord::orientation);
  visit("ground_set", "", "row of `/ground_sets`, from 0", &RunRecord::ground_set);
  visit_state(visit, "start_", " at the start",
              [](auto& r) -> decltype(auto) { return (r.start); });
  visit_state(visit, "stop_", " at the end",
              [](auto& r) -> decltype(auto) { return (r.result.final_state); });
  visit("duration_s", "s", "simulated time",
        [](auto& r) -> decltype(auto) { return (r.result.duration); });
  visit("path_length_m", "m", "length of the path of the centre of mass",
        [](auto& r) -> decltype(auto) { return (r.result.path_length); });
  visit("max_speed_m_s", "m/s", "largest speed of the centre of mass",
        [](auto& r) -> decltype(auto) { return (r.result.max_speed); });
  visit("max_penetration_m", "m", "largest overlap of any contact",
        [](auto& r) -> decltype(auto) { return (r.result.max_penetration); });
  visit("settled_penetration_m", "m", "largest overlap at the end",
        [](auto& r) -> decltype(auto) { return (r.result.settled_penetration); });
  visit_energies(visit);
  visit("contact_time_s", "s", "time with a contact",
        [](auto& r) -> decltype(auto) { return (r.contacts.contact_time); });
  visit("mean_contact_points", "",
        "number of contact points, averaged over the time with a contact",
        [](auto& r) -> decltype(auto) { return (r.contacts.mean_contact_points); });
  visit("longest_flight_m", "m", "length of the longest flight, in plan",
        [](auto& r) -> decltype(auto) { return (r.contacts.longest_flight); });
  visit("max_energy_j", "J", "largest translational plus rotational kinetic energy",
        [](auto& r) -> decltype(auto) { return (r.contacts.max_energy); });
  visit("max_spin_rad_s", "rad/s", "largest magnitude of the angular velocity",
        [](auto& r) -> decltype(auto) { return (r.contacts.max_spin); });
  visit_stiffness(visit);
  visit("contact_steps", "", "number of time steps with a contact",
        [](auto& r) -> decltype(auto) { return (r.result.contact_steps); });
  visit("impacts", "", "number of flights that end with a contact, of any length",
        [](auto& r) -> decltype(auto) { return (r.result.impacts); });
  visit("most_contact_points", "", "largest number of simultaneous contact points",
        [](auto& r) -> decltype(auto) { return (r.contacts.max_contact_points); });
  visit("stop_reason", "", "0 `rest`, 1 `left_terrain`, 2 `max_time`, 3 `error`",
        [](auto& r) -> decltype(auto) { return (r.result.stop_reason); });
  visit("below_ground", "", "1 if the run ended below ground, else 0",
        [](auto& r) -> decltype(auto) { return (r.result.below_ground); });
  visit("message", "", "message of a run that ended with an error",
        [](auto& r) -> decltype(auto) { return (r.result.message); });
}

template <class Visit>
void visit_columns(std::type_identity<Crossing>, const Visit& visit) {
  visit("run", "", "number of the run", &Crossing::run);
  visit("barrier", "", "row of `/barriers`", &Crossing::barrier);
  visit("time_s", "s", "time since release", &Crossing::time);
  const char* place = "position of the centre of mass";
  visit("x_m", "m", place, [](auto& c) -> decltype(auto) { return (c.position.x()); });
  visit("y_m", "m", place, [](auto& c) -> decltype(auto) { return (c.position.y()); });
  visit("z_m", "m", place, [](auto& c) -> decltype(auto) { return (c.position.z()); });
  const char* velocity = "velocity of the centre of mass";
  visit("vx_m_s", "m/s", velocity, [](auto& c) -> decltype(auto) { return (c.velocity.x()); });
  visit("vy_m_s", "m/s", velocity, [](auto& c) -> decltype(auto) { return (c.velocity.y()); });
  visit("vz_m_s", "m/s", velocity, [](auto& c) -> decltype(auto) { return (c.velocity.z()); });
  const char* spin = "angular velocity along the world axes";
  visit("wx_rad_s", "rad/s", spin,
        [](auto& c) -> decltype(auto) { return (c.angular_velocity.x()); });
  visit("wy_rad_s", "rad/s", spin,
        [](auto& c) -> decltype(auto) { return (c.angular_velocity.y()); });
  visit("wz_rad_s", "rad/s", spin,
        [](auto& c) -> decltype(auto) { return (c.angular_velocity.z()); });
  visit("height_m", "m", "height of the centre of mass above the ground below it",
        &Crossing::height);
  visit("clearance_m", "m", "height of the lowest skin point above the ground below it",
        &Crossing::clearance);
  visit("translational_energy_j", "J", "kinetic energy of the centre of mass",
        &Crossing::translational_energy);
  visit("rotational_energy_j", "J", "kinetic energy of the rotation", &Crossing::rotational_energy);
  visit("forward", "",
        "1 from the left of the line to its right, 0 from its right to its "
        "left; for a ring whose points run counter-clockwise 1 is an exit and "
        "0 an entry, for a ring whose points run clockwise 1 is an entry",
        &Crossing::forward);
}

template <class Visit>
void visit_columns(std::type_identity<Impact>, const Visit& visit) {
  visit("run", "", "number of the run", &Impact::run);
  visit("zone", "", "row of `/ground`: the ground zone of the first contact", &Impact::zone);
  visit("time_s", "s", "time of the first contact, since release", &Impact::time);
  visit("contact_s", "s",
        "time from the first contact to the next flight of 0.01 s or more, or "
        "to the end of the run; shorter flights do not end an impact",
        &Impact::contact_duration);
  const char* place = "position at the first contact";
  visit("x_m", "m", place, [](auto& i) -> decltype(auto) { return (i.position.x()); });
  visit("y_m", "m", place, [](auto& i) -> decltype(auto) { return (i.position.y()); });
  visit("z_m", "m", place, [](auto& i) -> decltype(auto) { return (i.position.z()); });
  const char* speed = "speed of the centre of mass at the first and at the last contact";
  visit("speed_before_m_s", "m/s", speed, &Impact::speed_before);
  visit("speed_after_m_s", "m/s", speed, &Impact::speed_after);
  const char* energy = "kinetic energy at the first and at the last contact";
  visit("translational_before_j", "J", energy, &Impact::translational_before);
  visit("translational_after_j", "J", energy, &Impact::translational_after);
  visit("rotational_before_j", "J", energy, &Impact::rotational_before);
  visit("rotational_after_j", "J", energy, &Impact::rotational_after);
  visit("depth_m", "m", "largest overlap during the impact", &Impact::depth);
}

template <class Visit>
void visit_columns(std::type_identity<PersistentBlockRecord>, const Visit& visit) {
  visit("run", "", "number of the run", &PersistentBlockRecord::run);
  visit("released_at_s", "s", "time of release, since the first release of the realisation",
        &PersistentBlockRecord::released_at);
  visit("raised_m", "m",
        "height of the start above the planned start, caused by blocks that "
        "lay there",
        &PersistentBlockRecord::raise_height);
  visit("moved_later_m", "m", "displacement by later blocks, from the stop of the block",
        &PersistentBlockRecord::later_displacement);
  visit("blocks_hit", "", "number of other blocks that the block touched during its own release",
        &PersistentBlockRecord::blocks_hit);
  visit("removed_at_s", "s",
        "time of removal, since the first release of the realisation; NaN if "
        "the block was not removed",
        &PersistentBlockRecord::removed_at);
}

template <class Visit>
void visit_columns(std::type_identity<EnergyRecord>, const Visit& visit) {
  const auto dissipated = [&](const std::string& prefix, const std::string& where,
                              DissipatedEnergy EnergySample::*part) {
    const auto add = [&](const char* name, const char* by, double DissipatedEnergy::*value) {
      visit(prefix + name, "J", "energy dissipated " + where + by + ", since the first release",
            [part, value](auto& e) -> decltype(auto) { return (e.energy.*part.*value); });
    };
    add("normal_j", " by normal forces", &DissipatedEnergy::normal);
    add("friction_j", " by friction", &DissipatedEnergy::friction);
    add("rolling_j", " by rolling resistance", &DissipatedEnergy::rolling);
  };
  visit("run", "", "number of the first run of the realisation", &EnergyRecord::run);
  visit("time_s", "s", "time since the first release",
        [](auto& e) -> decltype(auto) { return (e.energy.time); });
  visit("moving", "",
        "number of present blocks that are not at rest; a block is present "
        "until it leaves the terrain or is removed",
        [](auto& e) -> decltype(auto) { return (e.energy.moving); });
  visit("translational_j", "J", "kinetic energy of the centres of mass of the present blocks",
        [](auto& e) -> decltype(auto) { return (e.energy.translational); });
  visit("rotational_j", "J", "kinetic energy of the rotations of the present blocks",
        [](auto& e) -> decltype(auto) { return (e.energy.rotational); });
  visit("potential_j", "J", "m g z of the present blocks, z in the local frame",
        [](auto& e) -> decltype(auto) { return (e.energy.potential); });
  visit("stored_j", "J", "elastic energy of the contacts",
        [](auto& e) -> decltype(auto) { return (e.energy.stored); });
  visit("gone_j", "J",
        "kinetic and potential energy of blocks at the time at which they left "
        "the terrain or were removed",
        [](auto& e) -> decltype(auto) { return (e.energy.departed); });
  dissipated("ground_", "on the ground", &EnergySample::on_ground);
  dissipated("blocks_", "between blocks", &EnergySample::between_bodies);
  visit("reassigned_j", "J",
        "energy lost (negative: gained) when contacts change, since the first "
        "release",
        [](auto& e) -> decltype(auto) { return (e.energy.reassigned); });
}

/// Returns the number of rows of a trajectory dataset: one for time and one per state column.
inline std::size_t trajectory_row_count() {
  std::size_t rows = 1;
  visit_columns(kRowType<RigidState>, [&](const auto&...) { ++rows; });
  return rows;
}

/// Dataset name of a run's trajectory, zero-padded so that names sort like numbers: "00000012".
std::string trajectory_dataset_name(std::uint32_t run);

}  // namespace clast::study_detail

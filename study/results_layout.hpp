#pragma once
/// Names, units and fields of the columns of a results file: what the writer writes and the reader
/// reads.
#include <array>
#include <cstdint>
#include <span>

#include "study/results.hpp"

namespace clast::results_layout {

inline constexpr const char* kFormat = "clast results";
inline constexpr int kSchemaVersion = 4;
inline constexpr int kOldestSchema = 2;  ///< that is read

/// A column and the field of a row that it holds.
template <class Row, class T>
struct Column {
  const char* name;
  const char* unit;
  T& (*field)(Row&);
};

using RunIndex = Column<RunRecord, std::uint32_t>;
using RunValue = Column<RunRecord, double>;
using StateValue = Column<RigidState, double>;
using RunCount = Column<RunRecord, std::uint64_t>;
using ImpactIndex = Column<Impact, std::uint32_t>;
using ImpactValue = Column<Impact, double>;
using CrossingIndex = Column<Crossing, std::uint32_t>;
using CrossingValue = Column<Crossing, double>;

inline constexpr std::array<RunIndex, 5> kRunIndices{{
    {"run", "", [](RunRecord& r) -> std::uint32_t& { return r.run; }},
    {"block", "", [](RunRecord& r) -> std::uint32_t& { return r.block; }},
    {"point", "", [](RunRecord& r) -> std::uint32_t& { return r.point; }},
    {"orientation", "", [](RunRecord& r) -> std::uint32_t& { return r.orientation; }},
    {"ground_set", "", [](RunRecord& r) -> std::uint32_t& { return r.ground_set; }},
}};

inline constexpr std::array<RunCount, 3> kRunCounts{{
    {"contact_steps", "", [](RunRecord& r) -> std::uint64_t& { return r.result.contact_steps; }},
    {"impacts", "", [](RunRecord& r) -> std::uint64_t& { return r.result.impacts; }},
    {"most_contact_points", "",
     [](RunRecord& r) -> std::uint64_t& { return r.contacts.most_points; }},
}};

/// A state takes 13 columns: "start_x_m", "stop_x_m", and rows 1 to 13 of a trajectory.
inline constexpr std::array<StateValue, 13> kStateValues{{
    {"x_m", "m", [](RigidState& s) -> double& { return s.position.x(); }},
    {"y_m", "m", [](RigidState& s) -> double& { return s.position.y(); }},
    {"z_m", "m", [](RigidState& s) -> double& { return s.position.z(); }},
    {"qw", "", [](RigidState& s) -> double& { return s.orientation.w(); }},
    {"qx", "", [](RigidState& s) -> double& { return s.orientation.x(); }},
    {"qy", "", [](RigidState& s) -> double& { return s.orientation.y(); }},
    {"qz", "", [](RigidState& s) -> double& { return s.orientation.z(); }},
    {"vx_m_s", "m/s", [](RigidState& s) -> double& { return s.velocity.x(); }},
    {"vy_m_s", "m/s", [](RigidState& s) -> double& { return s.velocity.y(); }},
    {"vz_m_s", "m/s", [](RigidState& s) -> double& { return s.velocity.z(); }},
    {"wx_rad_s", "rad/s", [](RigidState& s) -> double& { return s.angular_velocity.x(); }},
    {"wy_rad_s", "rad/s", [](RigidState& s) -> double& { return s.angular_velocity.y(); }},
    {"wz_rad_s", "rad/s", [](RigidState& s) -> double& { return s.angular_velocity.z(); }},
}};
/// The states of a run and what their columns begin with.
struct StateOfRun {
  const char* prefix;
  RigidState& (*field)(RunRecord&);
};
inline constexpr std::array<StateOfRun, 2> kRunStates{{
    {"start_", [](RunRecord& r) -> RigidState& { return r.start; }},
    {"stop_", [](RunRecord& r) -> RigidState& { return r.result.final_state; }},
}};

inline constexpr std::array<RunValue, 17> kRunValues{{
    {"duration_s", "s", [](RunRecord& r) -> double& { return r.result.duration; }},
    {"path_length_m", "m", [](RunRecord& r) -> double& { return r.result.path_length; }},
    {"max_speed_m_s", "m/s", [](RunRecord& r) -> double& { return r.result.max_speed; }},
    {"max_penetration_m", "m", [](RunRecord& r) -> double& { return r.result.max_penetration; }},
    {"settled_penetration_m", "m",
     [](RunRecord& r) -> double& { return r.result.settled_penetration; }},
    {"energy_initial_j", "J", [](RunRecord& r) -> double& { return r.result.energy.initial; }},
    {"energy_final_j", "J", [](RunRecord& r) -> double& { return r.result.energy.final; }},
    {"energy_normal_j", "J", [](RunRecord& r) -> double& { return r.result.energy.normal; }},
    {"energy_friction_j", "J", [](RunRecord& r) -> double& { return r.result.energy.friction; }},
    {"energy_rolling_j", "J", [](RunRecord& r) -> double& { return r.result.energy.rolling; }},
    {"energy_reassigned_j", "J",
     [](RunRecord& r) -> double& { return r.result.energy.reassigned; }},
    {"energy_error", "", [](RunRecord& r) -> double& { return r.result.energy.error; }},
    {"contact_time_s", "s", [](RunRecord& r) -> double& { return r.contacts.contact_time; }},
    {"mean_contact_points", "", [](RunRecord& r) -> double& { return r.contacts.mean_points; }},
    {"longest_flight_m", "m", [](RunRecord& r) -> double& { return r.contacts.longest_flight; }},
    {"max_energy_j", "J", [](RunRecord& r) -> double& { return r.contacts.max_energy; }},
    {"max_spin_rad_s", "rad/s", [](RunRecord& r) -> double& { return r.contacts.max_spin; }},
}};

/// How stiff the contacts of a run were. Before schema 4 the first four were attributes of
/// /contact, one for all runs.
inline constexpr std::array<RunValue, 6> kRunStiffness{{
    {"stiffness_n_m", "N/m", [](RunRecord& r) -> double& { return r.stiffness.normal; }},
    {"tangential_stiffness_n_m", "N/m",
     [](RunRecord& r) -> double& { return r.stiffness.tangential; }},
    {"rolling_stiffness_n_m_rad", "N m/rad",
     [](RunRecord& r) -> double& { return r.stiffness.rolling; }},
    {"time_step_s", "s", [](RunRecord& r) -> double& { return r.stiffness.time_step; }},
    {"rest_depth_m", "m", [](RunRecord& r) -> double& { return r.rest_depth; }},
    {"impact_depth_m", "m", [](RunRecord& r) -> double& { return r.impact_depth; }},
}};

/// Columns of /runs that are not plain fields.
inline constexpr const char* kStopReason = "stop_reason";
inline constexpr const char* kMessage = "message";
inline constexpr const char* kBelowGround = "below_ground";

inline constexpr std::array<CrossingIndex, 2> kCrossingIndices{{
    {"run", "", [](Crossing& c) -> std::uint32_t& { return c.run; }},
    {"barrier", "", [](Crossing& c) -> std::uint32_t& { return c.barrier; }},
}};
inline constexpr const char* kForward = "forward";

inline constexpr std::array<CrossingValue, 14> kCrossingValues{{
    {"time_s", "s", [](Crossing& c) -> double& { return c.time; }},
    {"x_m", "m", [](Crossing& c) -> double& { return c.position.x(); }},
    {"y_m", "m", [](Crossing& c) -> double& { return c.position.y(); }},
    {"z_m", "m", [](Crossing& c) -> double& { return c.position.z(); }},
    {"vx_m_s", "m/s", [](Crossing& c) -> double& { return c.velocity.x(); }},
    {"vy_m_s", "m/s", [](Crossing& c) -> double& { return c.velocity.y(); }},
    {"vz_m_s", "m/s", [](Crossing& c) -> double& { return c.velocity.z(); }},
    {"wx_rad_s", "rad/s", [](Crossing& c) -> double& { return c.angular_velocity.x(); }},
    {"wy_rad_s", "rad/s", [](Crossing& c) -> double& { return c.angular_velocity.y(); }},
    {"wz_rad_s", "rad/s", [](Crossing& c) -> double& { return c.angular_velocity.z(); }},
    {"height_m", "m", [](Crossing& c) -> double& { return c.height; }},
    {"clearance_m", "m", [](Crossing& c) -> double& { return c.clearance; }},
    {"translational_energy_j", "J", [](Crossing& c) -> double& { return c.translational_energy; }},
    {"rotational_energy_j", "J", [](Crossing& c) -> double& { return c.rotational_energy; }},
}};

inline constexpr std::array<ImpactIndex, 2> kImpactIndices{{
    {"run", "", [](Impact& i) -> std::uint32_t& { return i.run; }},
    {"zone", "", [](Impact& i) -> std::uint32_t& { return i.zone; }},
}};
inline constexpr std::array<ImpactValue, 12> kImpactValues{{
    {"time_s", "s", [](Impact& i) -> double& { return i.time; }},
    {"contact_s", "s", [](Impact& i) -> double& { return i.contact_duration; }},
    {"x_m", "m", [](Impact& i) -> double& { return i.place.x(); }},
    {"y_m", "m", [](Impact& i) -> double& { return i.place.y(); }},
    {"z_m", "m", [](Impact& i) -> double& { return i.place.z(); }},
    {"speed_before_m_s", "m/s", [](Impact& i) -> double& { return i.speed_before; }},
    {"speed_after_m_s", "m/s", [](Impact& i) -> double& { return i.speed_after; }},
    {"translational_before_j", "J", [](Impact& i) -> double& { return i.translational_before; }},
    {"translational_after_j", "J", [](Impact& i) -> double& { return i.translational_after; }},
    {"rotational_before_j", "J", [](Impact& i) -> double& { return i.rotational_before; }},
    {"rotational_after_j", "J", [](Impact& i) -> double& { return i.rotational_after; }},
    {"depth_m", "m", [](Impact& i) -> double& { return i.depth; }},
}};

/// Rows of a trajectory dataset: time, then the state.
inline constexpr std::size_t kTrajectoryRows = 1 + kStateValues.size();

/// "00000012": sorts by name as by number.
std::string trajectory_name(std::uint32_t run);

}  // namespace clast::results_layout

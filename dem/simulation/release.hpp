#pragma once
/// Release of a single block on a terrain.
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dem/contact/energy_balance.hpp"
#include "dem/motion/rigid_body.hpp"
#include "dem/simulation/motion_settings.hpp"

namespace clast {

/// Reason why a run ended.
enum class StopReason { kRest, kLeftTerrain, kMaxTime, kError };
/// Returns "rest", "left_terrain", "max_time" or "error".
std::string name_of(StopReason reason);

/// Settings of the simulation of a single block.
struct ReleaseSettings : MotionSettings {
  double max_time = 60.0;  ///< s

  void check() const;  ///< throws InputError naming the field and its value
};

struct ContactSummary {
  std::uint32_t contact_count =
      0;                 ///< number of contact points; without any, the other members are undefined
  double overlap = 0.0;  ///< overlap of the deepest contact, m
  Vec3 position = Vec3::Zero();  ///< position of the deepest contact
  std::uint16_t zone = 0;        ///< ground zone at the deepest contact
};

/// Motion between two times. Observers receive the steps in order of time.
struct MotionStep {
  double begin_time = 0.0;  ///< s
  double end_time = 0.0;
  RigidState begin;
  RigidState end;
  /// True if the step is a free flight, whose intermediate states `free_flight` gives exactly. In
  /// simulations of several bodies, contacts may begin inside such a step.
  bool flight = false;
  ContactSummary contact_summary;  ///< contacts at the end of the step
  /// True if the step ends during an impact whose energy will still be corrected. The final
  /// velocities may be too large (docs/theory.md, Weights and energy).
  bool correction_pending = false;
};

/// Interpolates a state inside a step. It is exact in free flight. Otherwise the path of the centre
/// is cubic, and the rotation uniform.
RigidState interpolate_state(const RigidBody& body, const MotionStep& step, double time,
                             double gravity);

using MotionObserver = std::function<void(const MotionStep&)>;

struct ReleaseResult {
  StopReason stop_reason = StopReason::kError;
  std::string message;    ///< message of an error, otherwise empty
  double duration = 0.0;  ///< simulated time, s
  RigidState final_state;
  double path_length = 0.0;          ///< path length of the centre of mass, m
  double max_speed = 0.0;            ///< largest speed of the centre of mass, m/s
  double max_penetration = 0.0;      ///< largest overlap of any contact, m
  double settled_penetration = 0.0;  ///< largest overlap at the end, m
  bool below_ground = false;         ///< true if the block was below the ground at the end
  EnergyBalance energy;
  std::uint64_t contact_steps = 0;
  std::uint64_t flight_segments = 0;  ///< number of flight steps
  std::uint64_t impacts = 0;          ///< number of flights ended by a contact

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(stop_reason, message, duration, final_state, path_length, max_speed, max_penetration,
          settled_penetration, below_ground, energy, contact_steps, flight_segments, impacts);
  }
};

/// Simulates the motion of a single block on a terrain.
/// @param zones  parameters of each ground zone of the terrain
/// @param start  initial state, at rest or moving
/// @throws SimulationError  if the start is outside the terrain or overlaps the ground by more than
///                          `start_overlap`; later errors give the stop reason kError
ReleaseResult simulate_release(const TerrainSurface& terrain,
                               std::span<const GroundParameters> zones, const RigidBody& body,
                               const RigidState& start, const ReleaseSettings& settings,
                               const MotionObserver& observe = {});

}  // namespace clast

#pragma once
/// One block released on one terrain, until it stops.
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

/// Why a run ended. There is always one reason.
enum class StopReason { kRest, kLeftTerrain, kMaxTime, kError };
/// "rest", "left_terrain", "max_time", "error".
std::string name_of(StopReason reason);

/// Everything about a release that is not block, terrain or start.
struct ReleaseSettings : MotionSettings {
  double max_time = 60.0;  ///< s

  void check() const;  ///< throws InputError naming the field and its value
};

/// The contacts of an instant, summed up.
struct ContactSummary {
  std::uint32_t contact_count = 0;  ///< contact points; 0 in flight, where the rest means nothing
  double overlap = 0.0;             ///< of the deepest, m
  Vec3 position = Vec3::Zero();     ///< of the deepest
  std::uint16_t zone = 0;           ///< of the ground there
};

/// The motion between two instants, passed to observers in order of time.
struct MotionStep {
  double begin_time = 0.0;  ///< s
  double end_time = 0.0;
  RigidState begin;
  RigidState end;
  /// No contact: `free_flight` gives every state between exactly. A step of a body of a world is a
  /// flight when nothing touches the body as it begins; what touches it within acts in it already.
  bool flight = false;
  ContactSummary contact_summary;  ///< at the end; a flight that ends by a touch has one
  /// The velocities at the end are those within an impact that is balanced when it ends
  /// (docs/theory.md, Weights and energy); they can be too large until then.
  bool correction_pending = false;
};

/// The state inside a step: exact in flight, interpolated (cubic centre, steady turn) else.
RigidState interpolate_state(const RigidBody& body, const MotionStep& step, double time,
                             double gravity);

using MotionObserver = std::function<void(const MotionStep&)>;

/// The result of a run.
struct ReleaseResult {
  StopReason stop_reason = StopReason::kError;
  std::string message;    ///< of an error, else empty
  double duration = 0.0;  ///< simulated, s
  RigidState final_state;
  double path_length = 0.0;          ///< of the centre, m
  double max_speed = 0.0;            ///< of the centre, m/s
  double max_penetration = 0.0;      ///< largest overlap of any contact, m
  double settled_penetration = 0.0;  ///< largest overlap at the end, m
  bool below_ground = false;         ///< as docs/theory.md defines it
  EnergyBalance energy;
  std::uint64_t contact_steps = 0;
  std::uint64_t flight_segments = 0;  ///< parts of flights between two contact searches
  std::uint64_t impacts = 0;          ///< flights ended by a contact

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(stop_reason, message, duration, final_state, path_length, max_speed, max_penetration,
          settled_penetration, below_ground, energy, contact_steps, flight_segments, impacts);
  }
};

/// Runs one release.
///
/// @param zones  parameters of each ground zone of the terrain, by zone number
/// @param start  at rest or moving
/// @throws SimulationError  the start lies off the terrain or deeper in the ground than allowed;
///                          anything later is a stop reason, not an exception
ReleaseResult simulate_release(const TerrainSurface& terrain,
                               std::span<const GroundParameters> zones, const RigidBody& body,
                               const RigidState& start, const ReleaseSettings& settings,
                               const MotionObserver& observe = {});

}  // namespace clast

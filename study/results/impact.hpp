#pragma once
/// Impacts on the ground and contact statistics of a run.
#include <cstdint>
#include <optional>
#include <vector>

#include "dem/simulation/release.hpp"

namespace clast {

/// Impact: phase of contact between two flights. Flights shorter than `kMinFlight` do not end an
/// impact.
struct Impact {
  std::uint32_t run = 0;
  std::uint32_t zone = 0;  ///< ground zone of the first contact
  double time = 0.0;       ///< time of the first contact, s
  /// Time from the first contact to the next flight or the end of the run, s.
  double contact_duration = 0.0;
  Vec3 position = Vec3::Zero();       ///< position of the first contact, m
  double speed_before = 0.0;          ///< speed of the centre of mass at the first contact, m/s
  double speed_after = 0.0;           ///< speed of the centre of mass at the last contact, m/s
  double translational_before = 0.0;  ///< kinetic energy of the translation at the first contact, J
  double translational_after = 0.0;
  double rotational_before = 0.0;
  double rotational_after = 0.0;
  double depth = 0.0;  ///< largest overlap during the impact, m

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, zone, time, contact_duration, position, speed_before, speed_after,
          translational_before, translational_after, rotational_before, rotational_after, depth);
  }
};

/// Minimum duration of a flight, s. It corresponds to 0.5 mm of free fall.
inline constexpr double kMinFlight = 0.01;

/// Contact statistics and maxima of motion of a run.
struct ContactStatistics {
  double contact_time = 0.0;         ///< time with a contact, s
  double mean_contact_points = 0.0;  ///< mean number of contact points during `contact_time`
  std::uint64_t max_contact_points = 0;
  double longest_flight = 0.0;  ///< longest horizontal distance between two contacts, m
  double max_energy = 0.0;      ///< largest kinetic energy of translation and rotation, J
  double max_spin = 0.0;        ///< largest angular speed, rad/s

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(contact_time, mean_contact_points, max_contact_points, longest_flight, max_energy,
          max_spin);
  }
};

/// Records the impacts of a run from its motion steps.
class ImpactObserver {
 public:
  ImpactObserver(const RigidBody& body, std::uint32_t run) : body_(body), run_(run) {}

  void observe_step(const MotionStep& step);
  /// Ends an open impact. Must be called once after the last step.
  void finish();
  /// Serialises the recorded impacts and the open one.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(impacts, last_contact_states, statistics, first_, open_, last_touch_, last_touch_time_,
          flight_, take_off_);
  }

  std::vector<Impact> impacts;
  std::vector<RigidState> last_contact_states;  ///< state at the last contact of each impact
  ContactStatistics statistics;

 private:
  void begin_impact(const MotionStep& step);
  void end_impact();
  void update_maxima(const RigidState& state);

  const RigidBody& body_;
  std::uint32_t run_;
  bool first_ = true;
  std::optional<Impact> open_;
  RigidState last_touch_;  ///< state at the last contact of the open impact
  double last_touch_time_ = 0.0;
  double flight_ = 0.0;           ///< time since the last contact, s
  std::optional<Vec2> take_off_;  ///< start of the current flight
};

}  // namespace clast

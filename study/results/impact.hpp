#pragma once
/// Impacts of a block on the ground, and what a run shows of its contacts.
#include <cstdint>
#include <optional>
#include <vector>

#include "dem/simulation/release.hpp"

namespace clast {

/// One impact: a stretch of contact between two flights. Flights shorter than `kShortestFlight` do
/// not end it, so that a block that rolls on its corners makes one impact, not hundreds.
struct Impact {
  std::uint32_t run = 0;
  std::uint32_t zone = 0;             ///< ground zone of the first touch
  double time = 0.0;                  ///< of the first touch, s
  double contact_duration = 0.0;      ///< until the next flight, or the end of the run, s
  Vec3 place = Vec3::Zero();          ///< of the first touch, m
  double speed_before = 0.0;          ///< of the centre at the first touch, m/s
  double speed_after = 0.0;           ///< ... at the last
  double translational_before = 0.0;  ///< J
  double translational_after = 0.0;
  double rotational_before = 0.0;
  double rotational_after = 0.0;
  double depth = 0.0;  ///< largest overlap in between, m

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, zone, time, contact_duration, place, speed_before, speed_after, translational_before,
          translational_after, rotational_before, rotational_after, depth);
  }
};

/// A flight that counts lasts as long at least, s: 0.5 mm of free fall.
inline constexpr double kShortestFlight = 0.01;

/// What a run shows of its contacts, and maxima of its motion.
struct ContactStatistics {
  double contact_time = 0.0;  ///< with a contact, s
  double mean_points = 0.0;   ///< contact points while there are any, averaged over time
  std::uint64_t most_points = 0;
  double longest_flight = 0.0;  ///< m, in plan
  double max_energy = 0.0;      ///< translational and rotational, J
  double max_spin = 0.0;        ///< rad/s

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(contact_time, mean_points, most_points, longest_flight, max_energy, max_spin);
  }
};

/// Gathers the impacts of one run from its motion as it goes by.
class ImpactObserver {
 public:
  ImpactObserver(const RigidBody& body, std::uint32_t run) : body_(body), run_(run) {}

  void see(const MotionStep& step);
  /// Ends what is under way; to be called once, after the last step.
  void finish();
  /// All that it has seen, and what is under way.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(impacts, last_touches, statistics, first_, open_, last_touch_, last_touch_time_, flight_,
          take_off_);
  }

  std::vector<Impact> impacts;
  std::vector<RigidState> last_touches;  ///< state at the last touch of each impact
  ContactStatistics statistics;

 private:
  void begin_impact(const MotionStep& step);
  void end_impact();
  void update_maxima(const RigidState& state);

  const RigidBody& body_;
  std::uint32_t run_;
  bool first_ = true;
  std::optional<Impact> open_;  ///< under way
  RigidState last_touch_;       ///< of the impact under way
  double last_touch_time_ = 0.0;
  double flight_ = 0.0;           ///< time since the last touch, s
  std::optional<Vec2> take_off_;  ///< where the present flight began
};

}  // namespace clast

#pragma once
/// Detection of bodies that have stopped moving.
#include <optional>

#include "dem/motion/rigid_body.hpp"

namespace clast::dem_detail {

/// Detects stationary bodies by comparing the mean poses in consecutive time windows. A body at
/// rest may keep rocking, because its contact springs are undamped. It is stationary if the mean
/// poses of two windows agree.
class SleepDetector {
 public:
  /// Adds the state at the end of a time step.
  /// @param state  state of the body at the end of the step
  /// @param window  length of a time window, s
  /// @param tolerance  largest distance of any body point between two mean poses that agree, m
  /// @param radius  radius of the body about its centre, m
  void add_step(const RigidState& state, double step, double window, double tolerance,
                double radius);
  /// Restarts the detection.
  void reset() { *this = {}; }

  /// True if the mean poses of the last two time windows agreed within the tolerance. It stays true
  /// until two windows differ by more than four times the tolerance.
  bool is_stationary() const { return is_stationary_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(sum_, duration_, last_, is_stationary_);
  }

 private:
  struct PoseSum {
    Vec3 position = Vec3::Zero();
    Eigen::Vector4d rotation = Eigen::Vector4d::Zero();  ///< quaternion sum in one hemisphere

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(position, rotation);
    }
  };
  PoseSum sum_;  ///< time integral of the pose over the current window
  double duration_ = 0.0;
  std::optional<PoseSum> last_;
  bool is_stationary_ = false;
};

}  // namespace clast::dem_detail

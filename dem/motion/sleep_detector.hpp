#pragma once
/// Whether a body stays where it is, seen over time.
#include <optional>

#include "dem/motion/rigid_body.hpp"

namespace clast::dem_detail {

/// Mean places over windows of time. A block at rest may go on rocking: its tangential and rolling
/// springs have no damping. It does not go anywhere if the means of two windows, one after the
/// other, agree.
class SleepDetector {
 public:
  /// Adds a step at the end of which the body was at `state`.
  /// @param window  s
  /// @param near    distance of two means that agree, m, of any point of the body
  /// @param radius  of the body about its centre, m
  void add_step(const RigidState& state, double step, double window, double tolerance,
                double radius);
  /// Begins anew: the body moves.
  void reset() { *this = {}; }

  /// The last two windows agree. From then on until they differ by several times as much, so that
  /// a body that creeps at the limit does not change its mind all the time.
  bool is_stationary() const { return is_stationary_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(sum_, duration_, last_, is_stationary_);
  }

 private:
  struct MeanPose {
    Vec3 position = Vec3::Zero();
    Eigen::Vector4d rotation = Eigen::Vector4d::Zero();  ///< quaternion, of one hemisphere

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(position, rotation);
    }
  };
  MeanPose sum_;  ///< times duration, of the window under way
  double duration_ = 0.0;
  std::optional<MeanPose> last_;
  bool is_stationary_ = false;
};

}  // namespace clast::dem_detail

#pragma once
/// Torque-free rotation in closed form, with Jacobi elliptic functions for the angular velocity and
/// an elliptic integral of the third kind for the precession. @cite landau1976 @cite carlson1995
#include "core/types.hpp"

namespace clast::dem_detail {

/// Torque-free rotation from an initial state. The cost does not depend on the duration.
class FreeRotation {
 public:
  /// Computes the constants of the closed-form solution.
  /// @param moments  principal moments of inertia, along the body axes, kg m^2
  /// @param orientation  orientation at time 0, from body to world axes
  /// @param momentum  angular momentum, world axes, kg m^2/s
  FreeRotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum);

  /// Returns the orientation (world_from_body) after a time, s, which may be negative.
  Quat orientation_after(double duration) const;

 private:
  /// Computes the constants of the closed form after the axes are chosen.
  /// @param in_body  direction of the momentum in body axes, unit
  /// @param sign  +1 or -1, such that the differences of inverse moments between the pole axis and
  ///              the others are positive
  void set_polhode(const Vec3& mobility, const Vec3& in_body, double size, double sign,
                   double decider);
  /// Returns an orthonormal frame in body axes. Its columns are the direction of the momentum, the
  /// perpendicular direction towards the pole axis, and their cross product.
  /// @param amplitude  Jacobi amplitude, which grows with time, rad
  Mat3 momentum_frame_at(double amplitude) const;
  double third_kind_integral(double amplitude) const;

  Vec3 moments_;
  Quat orientation_;
  Vec3 momentum_;
  /// True if the rotation is too close to the unstable axis for the closed form.
  bool uses_time_steps_ = false;
  Vec3 direction_ = Vec3::UnitZ();  ///< direction of the momentum, world axes
  double steady_rate_ = 0.0;        ///< angular speed for equal moments, rad/s
  bool is_steady_ = false;

  // Indices of the body axes. The pole is the axis about which the momentum precesses in the body
  // frame; `middle_` has the middle moment.
  int pole_ = 0, middle_ = 1, other_ = 2;
  double handedness_ =
      1.0;  ///< +1 if the axes pole, middle and other are right-handed, otherwise -1
  double pole_sign_ = 1.0;       ///< sign of the momentum along the pole
  double argument_rate_ = 0.0;   ///< d(argument of the elliptic functions)/dt, rad/s
  double modulus_ = 0.0;         ///< squared modulus k^2 of the elliptic functions
  double complement_ = 1.0;      ///< 1 - k^2
  double characteristic_ = 0.0;  ///< nu in the integrand of the precession, 1/(1 + nu sn^2)
  double precession_ = 0.0;      ///< constant part of the precession rate, rad/s
  double nutation_ = 0.0;        ///< factor of the integrand of the precession, rad/s
  double along_pole_ = 1.0;      ///< largest component of the unit momentum along the pole
  double spread_middle_ = 0.0, spread_other_ = 0.0;  ///< amplitudes of the other components
  double slope_middle_ = 1.0, slope_other_ = 1.0;    ///< their ratio, also if both vanish
  double first_amplitude_ = 0.0, first_argument_ = 0.0, first_integral_ = 0.0;
  double half_turn_integral_ = 0.0;  ///< integral of the third kind over an amplitude of pi
  Mat3 first_frame_ = Mat3::Identity();
};

}  // namespace clast::dem_detail

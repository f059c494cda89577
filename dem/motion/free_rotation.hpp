#pragma once
/// Torque-free rotation in closed form, with Jacobi elliptic functions for the angular velocity and
/// an elliptic integral of the third kind for the precession. @cite landau1976 @cite carlson1995
#include "core/types.hpp"

namespace clast::dem_detail {

/// Torque-free rotation from an initial state. The cost does not depend on the duration.
class FreeRotation {
 public:
  /// Prepares the closed form.
  /// @param moments  principal, along the body axes, kg m^2
  /// @param orientation  world_from_body at the start
  /// @param momentum  angular, world axes, kg m^2/s
  FreeRotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum);

  /// Returns world_from_body after a time, s, of either sign.
  Quat orientation_after(double duration) const;

 private:
  /// Computes the constants of the closed form for given axes.
  /// @param in_body  unit momentum along the body axes
  /// @param sign  makes all mobility differences from the pole's positive
  void set_polhode(const Vec3& mobility, const Vec3& in_body, double size, double sign,
                   double decider);
  /// Returns, as columns in body axes, the momentum, the pole's azimuth about it, and their cross
  /// product.
  Mat3 momentum_frame_at(double amplitude) const;
  double third_kind_integral(double amplitude) const;

  Vec3 moments_;
  Quat orientation_;
  Vec3 momentum_;
  bool stepped_ = false;            ///< too close to the unstable axis for the closed form
  Vec3 direction_ = Vec3::UnitZ();  ///< of the momentum, world axes
  double steady_rate_ = 0.0;        ///< rad/s; for equal moments
  bool steady_ = false;

  // Body axes by their part: the pole never turns away from the momentum's side, the middle one has
  // the middle moment.
  int pole_ = 0, middle_ = 1, other_ = 2;
  double sense_ = 1.0;           ///< +1 if pole, middle, other are right-handed
  double side_ = 1.0;            ///< sign of the momentum along the pole
  double argument_rate_ = 0.0;   ///< d(argument of the elliptic functions)/dt, rad/s
  double modulus_ = 0.0;         ///< k^2
  double complement_ = 1.0;      ///< 1 - k^2
  double characteristic_ = 0.0;  ///< nu: the integrand of the precession is 1/(1 + nu sn^2)
  double precession_ = 0.0;      ///< constant part, rad/s
  double nutation_ = 0.0;        ///< factor of the integrand, rad/s
  double along_pole_ = 1.0;      ///< largest component of the unit momentum along the pole
  double spread_middle_ = 0.0, spread_other_ = 0.0;  ///< amplitudes of the other components
  double slope_middle_ = 1.0, slope_other_ = 1.0;    ///< their ratio, also if both vanish
  double first_amplitude_ = 0.0, first_argument_ = 0.0, first_integral_ = 0.0;
  double half_turn_integral_ = 0.0;  ///< integral of the third kind over an amplitude of pi
  Mat3 first_frame_ = Mat3::Identity();
};

}  // namespace clast::dem_detail

#pragma once
/// Torque-free rotation of a rigid body in closed form: Jacobi's elliptic functions for the spin,
/// an elliptic integral of the third kind for the precession. @cite landau1976 @cite carlson1995
#include "core/types.hpp"

namespace clast::dem_detail {

/// A rotation without torque from one instant on. Costs the same for any duration.
class FreeRotation {
 public:
  /// @param moments      principal, along the body axes, kg m^2
  /// @param orientation  world_from_body at the beginning
  /// @param momentum     angular, world axes, kg m^2/s
  FreeRotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum);

  /// world_from_body after a time, s, of either sign.
  Quat orientation_after(double duration) const;

 private:
  /// Sets what the closed form needs, once the axes are known.
  /// @param in_body  unit momentum along the body axes
  /// @param sign     makes all differences of mobility from the pole's positive
  void set_polhode(const Vec3& mobility, const Vec3& in_body, double size, double sign,
                   double decider);
  /// Columns in body axes: the momentum, the pole's azimuth about it, and their product.
  Mat3 momentum_frame_at(double amplitude) const;
  double third_kind_integral(double amplitude) const;

  Vec3 moments_;
  Quat orientation_;
  Vec3 momentum_;
  bool stepped_ = false;            ///< too close to the unstable axis for the closed form
  Vec3 direction_ = Vec3::UnitZ();  ///< of the momentum, world axes
  double steady_rate_ = 0.0;        ///< rad/s; all there is when every axis is the same
  bool steady_ = false;

  // Body axes by their part: the pole never turns away from the momentum's side, the middle one has
  // the middle moment.
  int pole_ = 0, middle_ = 1, other_ = 2;
  double sense_ = 1.0;           ///< +1 when pole, middle, other are right-handed
  double side_ = 1.0;            ///< sign of the momentum along the pole
  double argument_rate_ = 0.0;   ///< d(argument of the elliptic functions)/dt, rad/s
  double modulus_ = 0.0;         ///< k^2
  double complement_ = 1.0;      ///< 1 - k^2
  double characteristic_ = 0.0;  ///< nu: the precession's integrand is 1/(1 + nu sn^2)
  double precession_ = 0.0;      ///< rad/s, the constant part
  double nutation_ = 0.0;        ///< rad/s, factor of the integrand
  double along_pole_ = 1.0;      ///< largest share of the momentum along the pole
  double spread_middle_ = 0.0, spread_other_ = 0.0;  ///< amplitudes of its shares across
  double slope_middle_ = 1.0, slope_other_ = 1.0;    ///< their ratio, also when both vanish
  double first_amplitude_ = 0.0, first_argument_ = 0.0, first_integral_ = 0.0;
  double half_turn_integral_ = 0.0;  ///< of the third kind over an amplitude of pi
  Mat3 first_frame_ = Mat3::Identity();
};

}  // namespace clast::dem_detail

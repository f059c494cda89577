#include "dem/motion/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace clast::dem_detail {
namespace {

/// Rotation per Runge-Kutta step, rad.
constexpr double kFlightTurn = 0.003;
/// Squared half angle below which four series terms give sine and cosine to the last bit.
constexpr double kSmallHalfSquared = 1e-3;

Vec3 body_spin(const Vec3& moments, const Quat& orientation, const Vec3& momentum) {
  const Vec3 in_body = rotated(orientation.conjugate(), momentum);
  return in_body.cwiseQuotient(moments);
}

Eigen::Vector4d rate(const Vec3& moments, const Eigen::Vector4d& coefficients,
                     const Vec3& momentum) {
  const Quat orientation(coefficients);
  const Vec3 spin = body_spin(moments, orientation, momentum);
  return 0.5 * (orientation * Quat(0.0, spin.x(), spin.y(), spin.z())).coeffs();
}

}  // namespace

Quat rotation_from_vector(const Vec3& rotation) {
  const double squared = 0.25 * rotation.squaredNorm();
  double cosine, half_sinc;
  if (squared < kSmallHalfSquared) {
    cosine = 1.0 - squared * (1.0 / 2.0 - squared * (1.0 / 24.0 - squared * (1.0 / 720.0)));
    half_sinc = 0.5 - squared * (1.0 / 12.0 - squared * (1.0 / 240.0 - squared * (1.0 / 10080.0)));
  } else {
    const double half = std::sqrt(squared);
    cosine = std::cos(half);
    half_sinc = 0.5 * std::sin(half) / half;
  }
  const Vec3 axis = half_sinc * rotation;
  return {cosine, axis.x(), axis.y(), axis.z()};
}

Vec3 angular_momentum(const Vec3& moments, const Quat& orientation, const Vec3& angular_velocity) {
  const Vec3 spin = rotated(orientation.conjugate(), angular_velocity);
  return rotated(orientation, moments.cwiseProduct(spin));
}

Vec3 angular_velocity(const Vec3& moments, const Quat& orientation, const Vec3& momentum) {
  return rotated(orientation, body_spin(moments, orientation, momentum));
}

RotationStep integrate_rotation_step(const Vec3& moments, const Quat& orientation,
                                     const Vec3& momentum, double step) {
  const Vec3 first = body_spin(moments, orientation, momentum);
  const Quat middle = orientation * rotation_from_vector(0.5 * step * first);
  const Vec3 spin = body_spin(moments, middle, momentum);
  const Quat turned = (orientation * rotation_from_vector(step * spin)).normalized();
  return {turned,
          0.5 * (rotated(orientation, first) + angular_velocity(moments, turned, momentum))};
}

Quat integrate_free_rotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum,
                             double duration) {
  const double fastest = momentum.norm() / moments.minCoeff();
  const double steps = std::max(1.0, std::ceil(fastest * std::abs(duration) / kFlightTurn));
  const double step = duration / steps;
  Eigen::Vector4d q = orientation.coeffs();
  for (double i = 0; i < steps; ++i) {
    const Eigen::Vector4d k1 = rate(moments, q, momentum);
    const Eigen::Vector4d k2 = rate(moments, q + 0.5 * step * k1, momentum);
    const Eigen::Vector4d k3 = rate(moments, q + 0.5 * step * k2, momentum);
    const Eigen::Vector4d k4 = rate(moments, q + step * k3, momentum);
    q += step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    q.normalize();
  }
  return Quat(q);
}

}  // namespace clast::dem_detail

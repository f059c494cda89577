#include "dem/motion/free_rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dem/motion/rotation.hpp"

namespace clast::dem_detail {
namespace {

/// Relative difference below which two inverse moments are equal.
constexpr double kSameMoments = 1e-14;
/// Smallest value of 1 - k^2; rounding does not resolve smaller distances from the separatrix.
constexpr double kMinComplement = 1e-30;
/// Components of the unit momentum perpendicular to the middle axis below which the rotation is
/// integrated in steps. Near this unstable axis, the amplitude is too inaccurate.
constexpr double kUnstableAmplitude = 1e-5;
constexpr int kLandenSteps = 40;

/// Arithmetic-geometric means of 1 and k', as in Landen's transformation.
struct Ladder {
  std::array<double, kLandenSteps + 1> a, b;
  int steps = 0;

  explicit Ladder(double complement) {
    a[0] = 1.0;
    b[0] = std::sqrt(complement);
    while (steps < kLandenSteps && a[steps] - b[steps] > 1e-16 * a[steps]) {
      a[steps + 1] = 0.5 * (a[steps] + b[steps]);
      b[steps + 1] = std::sqrt(a[steps] * b[steps]);
      ++steps;
    }
  }
};

/// Elliptic integral of the first kind, for any amplitude.
double first_kind(double amplitude, double complement) {
  const Ladder ladder(complement);
  double phi = amplitude, power = 1.0;
  for (int n = 0; n < ladder.steps; ++n) {
    const double s = std::sin(phi), c = std::cos(phi);
    const double turns = phi - std::atan2(s, c);
    phi += std::atan2(ladder.b[n] * s, ladder.a[n] * c) + turns;
    power *= 2.0;
  }
  return phi / (power * ladder.a[ladder.steps]);
}

/// Jacobi's amplitude, the inverse of `first_kind`.
double jacobi_amplitude(double argument, double complement) {
  const Ladder ladder(complement);
  double phi = std::ldexp(ladder.a[ladder.steps] * argument, ladder.steps);
  for (int n = ladder.steps; n > 0; --n) {
    const double c = 0.5 * (ladder.a[n - 1] - ladder.b[n - 1]);
    phi = 0.5 * (phi + std::asin(std::clamp(c / ladder.a[n] * std::sin(phi), -1.0, 1.0)));
  }
  return phi;
}

double square(double x) { return x * x; }

/// Carlson's degenerate integral R_C(x, y) for y > 0.
double carlson_c(double x, double y) {
  if (x < y) {
    const double root = std::sqrt((y - x) / y);
    if (root > 0.01) return std::atan2(std::sqrt(y - x), std::sqrt(x)) / std::sqrt(y - x);
    const double s = (y - x) / x;  // atan(sqrt s)/sqrt s, as a series
    return (1.0 - s * (1.0 / 3 - s * (1.0 / 5 - s * (1.0 / 7 - s * (1.0 / 9 - s / 11))))) /
           std::sqrt(x);
  }
  const double s = (x - y) / x;
  const double root = std::sqrt(s);
  if (root > 0.01) return std::atanh(root) / std::sqrt(x - y);
  return (1.0 + s * (1.0 / 3 + s * (1.0 / 5 + s * (1.0 / 7 + s * (1.0 / 9 + s / 11))))) /
         std::sqrt(x);
}

/// Carlson's R_F by duplication.
double carlson_f(double x, double y, double z) {
  const double mean = (x + y + z) / 3.0;
  double apart = std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)});
  const double dx = mean - x, dy = mean - y;
  double a = mean, scale = 1.0;
  while (apart * scale > 0.003 * a) {
    const double lambda = std::sqrt(x * y) + std::sqrt(x * z) + std::sqrt(y * z);
    a = 0.25 * (a + lambda);
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    scale *= 0.25;
  }
  const double px = dx * scale / a, py = dy * scale / a, pz = -px - py;
  const double e2 = px * py - pz * pz, e3 = px * py * pz;
  return (1.0 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44 - 5 * e2 * e2 * e2 / 208 +
          3 * e3 * e3 / 104 + e2 * e2 * e3 / 16) /
         std::sqrt(a);
}

/// Carlson's R_J by duplication.
double carlson_j(double x, double y, double z, double p) {
  const double mean = (x + y + z + 2.0 * p) / 5.0;
  const double apart =
      std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z), std::abs(mean - p)});
  const double delta = (p - x) * (p - y) * (p - z);
  const double dx = mean - x, dy = mean - y, dz = mean - z;
  double a = mean, scale = 1.0, sum = 0.0;
  while (apart * scale > 0.003 * a) {
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z), rp = std::sqrt(p);
    const double lambda = rx * ry + rx * rz + ry * rz;
    const double d = (rp + rx) * (rp + ry) * (rp + rz);
    const double e = scale * scale * scale * delta / (d * d);
    sum += scale / d * carlson_c(1.0, 1.0 + e);
    a = 0.25 * (a + lambda);
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    p = 0.25 * (p + lambda);
    scale *= 0.25;
  }
  const double px = dx * scale / a, py = dy * scale / a, pz = dz * scale / a;
  const double pp = -0.5 * (px + py + pz);
  const double e2 = px * py + px * pz + py * pz - 3 * pp * pp;
  const double e3 = px * py * pz + 2 * e2 * pp + 4 * pp * pp * pp;
  const double e4 = (2 * px * py * pz + e2 * pp + 3 * pp * pp * pp) * pp;
  const double e5 = px * py * pz * pp * pp;
  const double series = 1.0 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 -
                        9 * e2 * e3 / 52 + 3 * e5 / 26 - e2 * e2 * e2 / 16 + 3 * e3 * e3 / 40 +
                        3 * e2 * e4 / 20 + 45 * e2 * e2 * e3 / 272 - 9 * (e3 * e4 + e2 * e5) / 68;
  return scale * series / (a * std::sqrt(a)) + 6.0 * sum;
}

}  // namespace

FreeRotation::FreeRotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum)
    : moments_(moments), orientation_(orientation), momentum_(momentum) {
  const double size = momentum.norm();
  const Vec3 mobility = moments.cwiseInverse();
  if (!(size > 0.0)) {
    is_steady_ = true;
    return;
  }
  direction_ = momentum / size;
  const Vec3 in_body = orientation.conjugate() * direction_;  // components of the unit momentum

  std::array<int, 3> axes = {0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](int i, int j) {
    return mobility[i] != mobility[j] ? mobility[i] > mobility[j] : i < j;
  });
  const double upper = mobility[axes[0]] - mobility[axes[1]];
  const double lower = mobility[axes[1]] - mobility[axes[2]];
  if (upper + lower <= kSameMoments * mobility[axes[0]]) {
    is_steady_ = true;
    steady_rate_ = size * mobility[axes[0]];
    return;
  }
  if (std::max(std::abs(in_body[axes[0]]), std::abs(in_body[axes[2]])) < kUnstableAmplitude &&
      upper > 0.0 && lower > 0.0) {
    uses_time_steps_ = true;
    return;
  }
  // The momentum circles the axis of the smallest or largest moment in the body frame.
  const double decider = upper * square(in_body[axes[0]]) - lower * square(in_body[axes[2]]);
  const bool about_smallest = decider > 0.0 || (decider == 0.0 && upper >= lower);
  if (!about_smallest) std::swap(axes[0], axes[2]);
  pole_ = axes[0];
  middle_ = axes[1];
  other_ = axes[2];
  set_polhode(mobility, in_body, size, about_smallest ? 1.0 : -1.0, std::abs(decider));
}

void FreeRotation::set_polhode(const Vec3& mobility, const Vec3& in_body, double size, double sign,
                               double decider) {
  // Inverse moment of the pole minus the others, positive with this sign.
  const double to_middle = sign * (mobility[pole_] - mobility[middle_]);
  const double to_other = sign * (mobility[pole_] - mobility[other_]);
  const double beyond = sign * (mobility[middle_] - mobility[other_]);

  // Squared components of the momentum: x across the pole, z away from the other axis.
  const double x = to_middle * square(in_body[middle_]) + to_other * square(in_body[other_]);
  const double z = to_other * square(in_body[pole_]) + beyond * square(in_body[middle_]);
  if (!(z > 0.0)) {  // about a principal axis
    is_steady_ = true;
    steady_rate_ = size * mobility[middle_];
    return;
  }
  complement_ = std::clamp(to_other * decider / (z * to_middle), kMinComplement, 1.0);
  modulus_ = 1.0 - complement_;
  characteristic_ = beyond / to_middle;
  pole_sign_ = in_body[pole_] < 0.0 ? -1.0 : 1.0;
  const bool right_handed = (middle_ - pole_ + 3) % 3 == 1;
  handedness_ = right_handed ? 1.0 : -1.0;
  // Signs of Euler's equations are for right-handed axes pole, middle, other with descending
  // inverse moments. Otherwise the orbit runs in the opposite direction.
  argument_rate_ = pole_sign_ * sign * handedness_ * size * std::sqrt(z * to_middle);
  precession_ = size * mobility[pole_];
  nutation_ = sign * size * to_other;
  along_pole_ = std::sqrt(z / to_other);
  slope_middle_ = std::sqrt(1.0 / to_middle);
  slope_other_ = std::sqrt(1.0 / to_other);
  spread_middle_ = std::sqrt(x) * slope_middle_;
  spread_other_ = std::sqrt(x) * slope_other_;

  first_amplitude_ = std::atan2(in_body[middle_] / slope_middle_, in_body[other_] / slope_other_);
  first_argument_ = first_kind(first_amplitude_, complement_);
  half_turn_integral_ =
      2.0 * (carlson_f(0.0, complement_, 1.0) -
             characteristic_ / 3.0 * carlson_j(0.0, complement_, 1.0, 1.0 + characteristic_));
  first_integral_ = third_kind_integral(first_amplitude_);
  first_frame_ = momentum_frame_at(first_amplitude_);
}

double FreeRotation::third_kind_integral(double amplitude) const {
  const double half_turns = std::round(amplitude / kPi);
  const double rest = amplitude - half_turns * kPi;
  const double s = std::sin(rest), c = std::cos(rest);
  const double delta = complement_ + modulus_ * c * c;
  const double incomplete = s * carlson_f(c * c, delta, 1.0) -
                            characteristic_ / 3.0 * s * s * s *
                                carlson_j(c * c, delta, 1.0, 1.0 + characteristic_ * s * s);
  return half_turns * half_turn_integral_ + incomplete;
}

Mat3 FreeRotation::momentum_frame_at(double amplitude) const {
  const double s = std::sin(amplitude), c = std::cos(amplitude);
  const double along = pole_sign_ * along_pole_ * std::sqrt(complement_ + modulus_ * c * c);
  const double across = std::hypot(spread_middle_ * s, spread_other_ * c);
  const double norm = std::hypot(along, across);
  const double cosine = along / norm, sine = across / norm;
  Vec3 heading = Vec3::Zero();  // of the momentum component perpendicular to the pole
  heading[middle_] = slope_middle_ * s;
  heading[other_] = slope_other_ * c;
  heading.normalize();
  Vec3 momentum = sine * heading, pole = -cosine * heading;
  momentum[pole_] += cosine;
  pole[pole_] += sine;
  Mat3 frame;
  frame << momentum, pole, momentum.cross(pole);
  return frame;
}

Quat FreeRotation::orientation_after(double duration) const {
  if (is_steady_) {
    return (rotation_from_vector(steady_rate_ * duration * direction_) * orientation_).normalized();
  }
  if (uses_time_steps_) return integrate_free_rotation(moments_, orientation_, momentum_, duration);
  const double amplitude =
      jacobi_amplitude(first_argument_ + argument_rate_ * duration, complement_);
  const double precessed =
      precession_ * duration -
      nutation_ / argument_rate_ * (third_kind_integral(amplitude) - first_integral_);
  const Mat3 turned = first_frame_ * momentum_frame_at(amplitude).transpose();
  return (rotation_from_vector(precessed * direction_) * orientation_ * Quat(turned)).normalized();
}

}  // namespace clast::dem_detail

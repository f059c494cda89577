#include "core/random.hpp"

#include <cmath>

namespace clast {

std::uint64_t Random::next_bits() {
  state_ += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double Random::uniform() { return static_cast<double>(next_bits() >> 11) * 0x1.0p-53; }

double Random::normal() {
  while (true) {
    const double u = uniform(-1.0, 1.0);
    const double v = uniform(-1.0, 1.0);
    const double s = u * u + v * v;
    if (s > 0.0 && s < 1.0) return u * std::sqrt(-2.0 * std::log(s) / s);
  }
}

Vec3 Random::unit_vector() {
  const double z = uniform(-1.0, 1.0);
  const double angle = uniform(0.0, 2.0 * kPi);
  const double radius = std::sqrt(1.0 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Quat Random::rotation() {
  const double share = uniform();
  const double first = uniform(0.0, 2.0 * kPi);
  const double second = uniform(0.0, 2.0 * kPi);
  const double a = std::sqrt(1.0 - share);
  const double b = std::sqrt(share);
  return {a * std::sin(first), a * std::cos(first), b * std::sin(second), b * std::cos(second)};
}

}  // namespace clast

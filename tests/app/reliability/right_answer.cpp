#include "tests/app/reliability/right_answer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clast::reliability {

DamagedScan of(const Body& body, TriangleMesh damaged, const Tolerance& tolerance) {
  return {std::move(damaged), {{body.truth, tolerance}}};
}

Tolerance effect(const Truth& truth, const Truth& moved) {
  return {std::abs(moved.volume / truth.volume - 1.0),
          {std::abs(moved.axes.L / truth.axes.L - 1.0), std::abs(moved.axes.I / truth.axes.I - 1.0),
           std::abs(moved.axes.S / truth.axes.S - 1.0)}};
}

Tolerance at_least_usual(Tolerance tolerance, double factor) {
  const Tolerance usual;
  tolerance.volume = std::max(usual.volume, factor * tolerance.volume);
  for (std::size_t k = 0; k < 3; ++k) {
    tolerance.axes[k] = std::max(usual.axes[k], factor * tolerance.axes[k]);
  }
  return tolerance;
}

Tolerance cloud_tolerance(std::size_t points, double noise) {
  constexpr double kSparse = 8000, kNoisy = 0.005;
  const double rough = std::min(1.0, noise / kNoisy);
  const bool sparse = static_cast<double>(points) < kSparse;
  const double sides = sparse ? 0.03 : 0.015 + 0.015 * rough;
  return {std::max(sparse ? 0.025 : 0.01, 0.01 + 0.01 * rough), {sides, sides, sides}};
}

}  // namespace clast::reliability

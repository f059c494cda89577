#include "reconstruct/detail/stored_digits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace clast::detail {

namespace {

constexpr int kFloatBits = 24, kTextDigits = 7;
/// How far from a whole number of steps a coordinate read from text may be, by its rounding.
constexpr double kRounding = 1e-6;

/// By its bits: a conversion to float and back may be optimised away.
bool is_float(double value) {
  constexpr std::uint64_t kBeyond = (std::uint64_t{1} << (53 - kFloatBits)) - 1;
  return (std::bit_cast<std::uint64_t>(value) & kBeyond) == 0;
}

bool is_multiple(double value, double step) {
  const double steps = value / step;
  return std::abs(steps - std::round(steps)) < kRounding;
}

}  // namespace

std::optional<CoordinateStep> coordinate_step(const TriangleMesh& mesh) {
  CoordinateStep coarsest;
  for (int axis = 0; axis < 3; ++axis) {
    double largest = 0.0;
    bool floats = true;
    for (const Vec3& v : mesh.vertices) {
      largest = std::max(largest, std::abs(v[axis]));
      floats = floats && is_float(v[axis]);
    }
    if (largest == 0.0) continue;
    double step = std::exp2(std::ilogb(largest) - (kFloatBits - 1));
    if (!floats) {
      step = std::pow(10.0, std::floor(std::log10(largest)) - (kTextDigits - 1));
      const bool short_text =
          std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                      [&](const Vec3& v) { return is_multiple(v[axis], step); });
      if (!short_text) continue;
    }
    if (step > coarsest.step) coarsest = {step, largest};
  }
  return coarsest.step > 0.0 ? std::optional(coarsest) : std::nullopt;
}

}  // namespace clast::detail

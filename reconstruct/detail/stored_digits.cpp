#include "reconstruct/detail/stored_digits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Coordinate steps, relative to the diagonal, above which the shape is lost, and above which they
/// are noted.
constexpr double kShapeLost = 1e-2, kDigitsLost = 1e-4;
/// Number of vertices that cannot all fall on the steps of a text file by chance or by hand.
constexpr std::size_t kNoChance = 100;

constexpr int kFloatBits = 24, kTextDigits = 7;
/// Largest distance of a coordinate in text from a whole number of steps, by rounding.
constexpr double kRounding = 1e-6;

/// Compares bits, because a conversion to float and back may be optimised away.
bool is_float(double value) {
  constexpr std::uint64_t kBeyond = (std::uint64_t{1} << (53 - kFloatBits)) - 1;
  return (std::bit_cast<std::uint64_t>(value) & kBeyond) == 0;
}

bool is_multiple(double value, double step) {
  const double steps = value / step;
  return std::abs(steps - std::round(steps)) < kRounding;
}

}  // namespace

std::optional<CoordinateResolution> find_coordinate_resolution(const TriangleMesh& mesh) {
  CoordinateResolution coarsest;
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

std::string check_coordinate_digits(const TriangleMesh& mesh, const std::filesystem::path& path,
                                    double unit) {
  const std::string extension = lower_case_extension(path);
  const bool keeps_floats =
      extension == ".stl" || extension == ".glb" || extension == ".gltf" || extension == ".3ds";
  if (!keeps_floats && mesh.vertices.size() < kNoChance) return "";
  const std::optional<CoordinateResolution> found = find_coordinate_resolution(mesh);
  if (!found) return "";
  const double diagonal = bounds(mesh).diagonal();
  if (!(diagonal > 0.0)) return "";  // one point has no shape to lose
  const double fraction = found->step / diagonal;
  if (!(fraction > kDigitsLost)) return "";
  const std::string text =
      "precision was lost in the file itself: its coordinates reach " +
      format_significant(found->max_coordinate, 9) + " and are stored in steps of " +
      format_significant(found->step * unit, 3) + " m, " + format_significant(100.0 * fraction, 3) +
      " % of the scan's diagonal of " + format_significant(diagonal * unit, 3) + " m";
  const std::string advice =
      "; export it again with a local origin (CloudCompare: accept the global shift when loading) "
      "or as PLY with doubles";
  if (fraction <= kShapeLost) return text + advice;
  throw InputError(path.string() + ": " + text + ", so its shape is lost" + advice);
}

}  // namespace clast::reconstruct_detail

#include "library/detail/block_checks.hpp"

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/detail/hdf5_records.hpp"
#include "massprops/sphero.hpp"

namespace clast::library_detail {

namespace {

/// Relative; far above the rounding of these numbers and far below any measurement error.
constexpr double kRounding = 1e-6;

void require_equal(double stored, double expected, double tolerance, const std::string& what,
                   const std::string& where) {
  check_stored_value(std::abs(stored - expected) <= tolerance * std::abs(expected), where,
                     what + " is " + format_significant(stored, 9) + ", but " +
                         format_significant(expected, 9) + " follows from the other values");
}

void check_moments(const Block& block, const std::string& where) {
  const Vec3& moments = block.principal.moments;
  const double slack = (kRounding + 2.0 * block.mass.relative_error) * moments[2];
  check_stored_value(moments[0] > 0.0 && moments[0] <= moments[1] && moments[1] <= moments[2],
                     where, "principal_moments are not positive and ascending");
  check_stored_value(
      moments[0] + moments[1] + slack >= moments[2], where,
      "principal_moments are impossible for a solid: the largest exceeds the sum of the others");
  // Between nearly equal moments the axes follow a convention.
  const Mat3 turn = block.principal.rotation.toRotationMatrix();
  const Mat3 along = turn.transpose() * block.mass.inertia * turn;
  const Mat3 off = along - Mat3(moments.asDiagonal());
  check_stored_value(off.cwiseAbs().maxCoeff() <= 10.0 * slack + kRounding * moments[2], where,
                     "inertia does not agree with principal_moments and source_from_body");
}

void check_box(const Block& block, const std::string& where) {
  const OrientedBox& box = block.box;
  check_stored_value(
      (box.axes.transpose() * box.axes - Mat3::Identity()).cwiseAbs().maxCoeff() < kRounding, where,
      "box_axes are not unit vectors at right angles");
  check_stored_value(
      box.lengths[0] >= box.lengths[1] && box.lengths[1] >= box.lengths[2] && box.lengths[2] > 0.0,
      where, "box_lengths are not positive and descending");
  Vec3 reach = Vec3::Zero();
  for (const Vec3& vertex : block.body.vertices) {
    reach = reach.cwiseMax((box.axes.transpose() * (vertex - box.centre)).cwiseAbs());
  }
  const Vec3 sides = 2.0 * (reach + Vec3::Constant(block.body.radius));
  const double slack = kRounding * (box.lengths[0] + kRounding * box.centre.norm());
  check_stored_value(
      (sides - box.lengths).cwiseAbs().maxCoeff() <= slack, where,
      "the box is not around the core: its sides are " + format_significant(box.lengths[0], 9) +
          ", " + format_significant(box.lengths[1], 9) + ", " +
          format_significant(box.lengths[2], 9) + " m, those of the core with its radius " +
          format_significant(sides[0], 9) + ", " + format_significant(sides[1], 9) + ", " +
          format_significant(sides[2], 9) + " m");
}

/// Volume of a convex core in closed form; empty for other cores, whose integration is slow.
std::optional<MassProperties> exact_properties(const Block& block) {
  if (block.mass.relative_error > 0.0) return std::nullopt;
  try {
    return convex_sphero_mass_properties(block.body, block.density);
  } catch (const GeometryError&) {  // not convex
    return std::nullopt;
  }
}

void check_volume(const Block& block, const std::string& where) {
  check_stored_value(block.mass.volume <= (1.0 + kRounding) * block.box.volume(), where,
                     "volume_m3 is " + format_significant(block.mass.volume, 9) +
                         ", more than the box's, " + format_significant(block.box.volume(), 9));
  const std::optional<MassProperties> exact = exact_properties(block);
  if (!exact) return;
  require_equal(block.mass.volume, exact->volume, kRounding, "volume_m3", where);
  require_equal(block.mass.inertia.trace(), exact->inertia.trace(), kRounding,
                "the trace of inertia", where);
  const double slack = kRounding * (block.box.lengths[0] + kRounding * exact->centre.norm());
  check_stored_value((block.mass.centre - exact->centre).norm() <= slack, where,
                     "centre is not that of the core");
}

}  // namespace

void check_block_consistency(const Block& block, const std::string& where) {
  require_equal(block.mass.mass, block.density * block.mass.volume, kRounding, "mass_kg", where);
  check_moments(block, where);
  check_box(block, where);
  check_volume(block, where);
}

}  // namespace clast::library_detail

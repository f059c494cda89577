#include "app/block_line.hpp"

#include "classify/schemes.hpp"
#include "core/number_text.hpp"
#include "library/unscaled.hpp"

namespace clast {

std::string mass_text(const Block& block) {
  return is_unscaled(block) ? "-" : rounded(block.mass.mass);
}

std::string length_unit_of(const Block& block) { return is_unscaled(block) ? "u" : "m"; }

std::string block_line(const Block& block) {
  const Axes axes = block.axes();
  const std::size_t count = block.body.vertices.size();
  const bool metric = !is_unscaled(block);
  const std::string unit = metric ? " m" : " model units";
  std::string line =
      block.id + ": " + std::to_string(count) + (count == 1 ? " vertex, " : " vertices, ") +
      rounded(axes.L, 3) + " x " + rounded(axes.I, 3) + " x " + rounded(axes.S, 3) + unit + ", " +
      rounded(block.mass.volume) + (metric ? " m3, " : " cubic units, ") +
      (metric ? rounded(block.mass.mass) + " kg, " : "UNSCALED: no mass, ") +
      sneed_folk_class(axes) + ", " + zingg_class(axes) + ", " + garcia_class(axes) + ", ";
  if (block.from_core) return line + "core with radius " + rounded(block.body.radius, 3) + unit;
  return line + "within " + rounded(block.deviation.hausdorff, 2) + unit + " of the scan (" +
         rounded(100.0 * block.deviation.hausdorff / axes.L, 2) + " % of L)";
}

}  // namespace clast

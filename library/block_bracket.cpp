#include "library/block_bracket.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "classify/possible_classes.hpp"
#include "core/number_text.hpp"
#include "library/unscaled.hpp"

namespace clast {

namespace {

constexpr double kSameMass = 1e-9;    ///< relative; a density made from the mass gives it back
constexpr double kHardlyOpen = 1e-3;  ///< of the volume; a scan weighs no better

AxesBounds including(const BoxSideBounds& sides, const Vec3& lengths) {
  const Vec3 low = sides.lower.cwiseMin(lengths), high = sides.upper.cwiseMax(lengths);
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

std::string range_text(double low, const std::optional<double>& upper, const std::string& unit) {
  if (!upper) return "at least " + format_significant(low, 4) + " " + unit;
  const double high = *upper;
  if (low == high) return format_significant(low, 4) + " " + unit;
  return "between " + format_significant(low, 4) + " and " + format_significant(high, 4) + " " +
         unit;
}

}  // namespace

BlockBracket derive_block_bracket(const Block& block) {
  const VolumeBracket& unseen = *block.volume_bracket;
  BlockBracket range;
  range.lower_mass = block.density * unseen.lower_volume;
  if (unseen.upper_volume) range.upper_mass = block.density * *unseen.upper_volume;
  range.lower_density = range.upper_density = block.density;
  const std::optional<double>& weighed = block.field.weighed_mass;
  if (weighed && std::abs(block.mass.mass - *weighed) <= kSameMass * *weighed) {
    range.lower_mass = *weighed;
    range.upper_mass = weighed;
    range.lower_density.reset();
    if (unseen.upper_volume) range.lower_density = *weighed / *unseen.upper_volume;
    range.upper_density = *weighed / unseen.lower_volume;
  }
  if (!unseen.sides) return range;
  range.axes = including(*unseen.sides, block.box.lengths);
  const auto& [low, high] = *range.axes;
  range.lower_s_c = std::max(0.0, low.L / high.I - 1.0);
  range.upper_s_c = high.L / low.I - 1.0;
  const AxesBounds probable =
      unseen.intervals ? including(unseen.intervals->sides, block.box.lengths) : *range.axes;
  for (const char* scheme : {"sneed-folk", "zingg", "garcia"}) {
    range.classes[scheme] = find_possible_classes(scheme, probable.lower, probable.upper);
  }
  return range;
}

std::string describe_volume_bracket(const Block& block) {
  const VolumeBracket& unseen = *block.volume_bracket;
  const bool metric = !is_unscaled(block);
  const bool is_open = unseen.filled_fraction > 0.0;
  const std::string filled = is_open ? format_significant(100.0 * unseen.filled_fraction, 2) +
                                           " % of the surface was not scanned but filled in"
                                     : "the surface is not known exactly";
  const std::optional<double>& upper = unseen.upper_volume;
  if (upper && *upper - unseen.lower_volume < kHardlyOpen * unseen.estimated_volume) {
    return (is_open ? "the scan was only slightly open: " : "") + filled + ", which leaves volume" +
           (metric ? " and mass" : "") + " uncertain by less than " +
           format_significant(100.0 * kHardlyOpen, 1) + " %";
  }
  const std::string text =
      (is_open ? "the scan was open: " : "") + filled + "; " +
      (upper ? "" : "too much of the block for an upper bound: ") + "volume " +
      range_text(unseen.lower_volume, upper, metric ? "m3" : "cubic model units") + " (best " +
      format_significant(unseen.estimated_volume, 4) + ")";
  const BlockBracket range = derive_block_bracket(block);
  const std::string mass =
      metric ? ", mass " + range_text(range.lower_mass, range.upper_mass, "kg") : "";
  const std::string likely = unseen.intervals ? "; with a probability of 90 %, volume " +
                                                    range_text(unseen.intervals->lower_volume,
                                                               unseen.intervals->upper_volume,
                                                               metric ? "m3" : "cubic model units")
                                              : "";
  return text + mass + likely +
         (upper ? "" : "; no upper bound can be given: scan more of the block");
}

}  // namespace clast

#include "library/unseen_range.hpp"

#include <algorithm>
#include <cmath>

#include "core/number_text.hpp"
#include "library/unscaled.hpp"

namespace clast {

namespace {

constexpr double kSameMass = 1e-9;    ///< relative; a density made from the mass gives it back
constexpr double kHardlyOpen = 1e-3;  ///< of the volume; a scan weighs no better
constexpr int kSteps = 10;            ///< boxes looked at from the lower to the block's, and on

Axes between(const Axes& from, const Axes& to, double share) {
  const auto mix = [&](double a, double b) { return a + share * (b - a); };
  return Axes::sorted(mix(from.L, to.L), mix(from.I, to.I), mix(from.S, to.S));
}

std::string range_text(double low, double high, const std::string& unit) {
  if (low == high) return with_digits(low, 4) + " " + unit;
  return "between " + with_digits(low, 4) + " and " + with_digits(high, 4) + " " + unit;
}

}  // namespace

UnseenRange unseen_range(const Block& block) {
  const UnseenPart& unseen = *block.unseen;
  UnseenRange range;
  range.lower_mass = block.density * unseen.lower_volume;
  range.upper_mass = block.density * unseen.upper_volume;
  range.lower_density = range.upper_density = block.density;
  const std::optional<double>& weighed = block.field.weighed_mass;
  if (weighed && std::abs(block.mass.mass - *weighed) <= kSameMass * *weighed) {
    range.lower_mass = range.upper_mass = *weighed;
    range.lower_density = *weighed / unseen.upper_volume;
    range.upper_density = *weighed / unseen.lower_volume;
  }

  range.lower_s_c = range.upper_s_c = elongation_s_c(block.axes());
  const auto include = [&](const Axes& axes) {
    range.lower_s_c = std::min(range.lower_s_c, elongation_s_c(axes));
    range.upper_s_c = std::max(range.upper_s_c, elongation_s_c(axes));
    for (const char* scheme : {"sneed-folk", "zingg", "garcia"}) {
      std::vector<std::string>& met = range.classes[scheme];
      const std::string name = shape_class(scheme, axes);
      if (std::find(met.begin(), met.end(), name) == met.end()) met.push_back(name);
    }
  };
  for (int i = 0; i < kSteps; ++i) {
    include(between(unseen.lower_axes, block.axes(), static_cast<double>(i) / kSteps));
  }
  for (int i = 0; i <= kSteps; ++i) {
    include(between(block.axes(), unseen.upper_axes, static_cast<double>(i) / kSteps));
  }
  return range;
}

std::string described_unseen(const Block& block) {
  const UnseenPart& unseen = *block.unseen;
  const bool metric = !is_unscaled(block);
  const std::string filled =
      with_digits(100.0 * unseen.invented_share, 2) + " % of the surface is not seen but filled in";
  if (unseen.upper_volume - unseen.lower_volume < kHardlyOpen * unseen.best_volume) {
    return "the scan was open, but hardly: " + filled + ", which leaves volume" +
           (metric ? " and mass" : "") + " open by less than " +
           with_digits(100.0 * kHardlyOpen, 1) + " %";
  }
  const std::string text =
      "the scan was open: " + filled + "; volume " +
      range_text(unseen.lower_volume, unseen.upper_volume, metric ? "m3" : "cubic model units") +
      " (best " + with_digits(unseen.best_volume, 4) + ")";
  if (!metric) return text;
  const UnseenRange range = unseen_range(block);
  return text + ", mass " + range_text(range.lower_mass, range.upper_mass, "kg");
}

}  // namespace clast

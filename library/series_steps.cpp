#include "library/series_steps.hpp"

#include "classify/form_grid.hpp"
#include "core/error.hpp"
#include "library/variation_ranges.hpp"

namespace clast {

namespace {

std::vector<Axes> forms_of(const FormGrid& grid) {
  if (grid.diagram == "zingg") return zingg_grid(grid.steps, grid.min_ratio);
  if (grid.diagram == "sneed-folk") return sneed_folk_grid(grid.steps, grid.min_ratio);
  throw InputError("`grid` \"" + grid.diagram + "\" is not a diagram; use sneed-folk or zingg");
}

}  // namespace

std::vector<Variation> VariationTargets::variations() const {
  std::vector<Variation> all;
  for (const BoxRatios& stretch : ratios) all.emplace_back(StretchVariation{stretch});
  if (grid) {
    for (const Axes& axes : forms_of(*grid)) {
      all.emplace_back(StretchVariation{{axes.I / axes.L, axes.S / axes.L}});
    }
  }
  for (const double share : convexity) all.emplace_back(ConvexityVariation{share});
  for (const double share : rounding) all.emplace_back(RoundingVariation{share});
  for (const double value : roundness) all.emplace_back(RoundnessVariation{value, roundness_edge});
  for (const std::size_t count : vertices) all.emplace_back(VertexCountVariation{count});
  for (const double gain : detail) all.emplace_back(DetailVariation{gain, degree});
  for (const std::string& name : reference) {
    all.emplace_back(ReferenceVariation{parse_reference_shape(name), exponent});
  }
  for (const std::string& name : inertia)
    all.emplace_back(InertiaVariation{parse_reference_shape(name)});
  return all;
}

const std::vector<std::string>& form_grid_diagram_names() {
  static const std::vector<std::string> kNames = {"sneed-folk", "zingg"};
  return kNames;
}

const std::vector<std::string>& inertia_body_names() {
  static const std::vector<std::string> kNames = {"ellipsoid", "box"};
  return kNames;
}

BoxRatios check_stretch_ratios(double i_over_l, double s_over_l, const std::string& written) {
  if (kVariedRatioRange.contains(i_over_l) && kVariedRatioRange.contains(s_over_l) &&
      s_over_l <= i_over_l) {
    return {i_over_l, s_over_l};
  }
  throw InputError("`to` " + written + ": give I/L,S/L, such as 0.8,0.5, both " +
                   kVariedRatioRange.describe() + " and S/L at most I/L");
}

}  // namespace clast

#pragma once
/// What each block of a series is varied by, as options, campaign files and Python write it.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "library/block_variation.hpp"

namespace clast {

/// Forms all over a diagram (classify/form_grid.hpp).
struct FormGrid {
  std::string diagram = "sneed-folk";  ///< or "zingg"
  int steps = 10;
  double least = 0.2;  ///< S/L, in zingg I/L and S/I
};

/// Any number of targets of each kind.
struct SeriesTargets {
  std::vector<BoxRatios> ratios;
  std::optional<FormGrid> grid;
  std::vector<double> convexity;
  std::vector<double> rounding;  ///< radius over S
  std::vector<double> roundness;
  double roundness_edge = kDefaultRoundnessEdge;
  std::vector<std::size_t> vertices;
  std::vector<double> detail;  ///< factors
  int degree = 6;              ///< of the detail
  std::vector<std::string> reference;
  double exponent = 4.0;  ///< of superellipsoids
  std::vector<std::string> inertia;

  /// In the order of the members.
  /// @throws InputError  an unknown diagram or reference form; as `sneed_folk_grid`
  std::vector<Variation> variations() const;
};

/// Names of the diagrams of `FormGrid`, and of the bodies of `InertiaVariation`.
const std::vector<std::string>& form_grid_names();
const std::vector<std::string>& inertia_form_names();

/// @param asked  the ratios as they were written, for the message
/// @throws InputError  not I/L and S/L of a box, both from 0.01 to 1, or no numbers (NaN)
BoxRatios check_stretch_ratios(double i_over_l, double s_over_l, const std::string& written);

}  // namespace clast

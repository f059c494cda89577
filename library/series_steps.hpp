#pragma once
/// Targets of a series of variations, as given by options, campaign files and Python.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "library/block_variation.hpp"

namespace clast {

/// Grid of shapes over a diagram (classify/form_grid.hpp).
struct FormGrid {
  std::string diagram = "sneed-folk";  ///< or "zingg"
  int steps = 10;
  double least = 0.2;  ///< S/L, for zingg I/L and S/I
};

/// Targets of variations, any number of each kind.
struct SeriesTargets {
  std::vector<BoxRatios> ratios;
  std::optional<FormGrid> grid;
  std::vector<double> convexity;
  std::vector<double> rounding;  ///< radius over S
  std::vector<double> roundness;
  double roundness_edge = kDefaultRoundnessEdge;
  std::vector<std::size_t> vertices;
  std::vector<double> detail;  ///< gains
  int degree = 6;              ///< of the detail
  std::vector<std::string> reference;
  double exponent = 4.0;  ///< of superellipsoids
  std::vector<std::string> inertia;

  /// Returns the variations in the order of the members.
  /// @throws InputError  if a diagram or reference shape is unknown; or as `sneed_folk_grid`
  std::vector<Variation> variations() const;
};

/// Names of the diagrams of `FormGrid`, and of the bodies of `InertiaVariation`.
const std::vector<std::string>& form_grid_names();
const std::vector<std::string>& inertia_form_names();

/// Checks target ratios.
/// @param written  ratios as written, for the message
/// @throws InputError  unless they are I/L and S/L of a box, both from 0.01 to 1
BoxRatios check_stretch_ratios(double i_over_l, double s_over_l, const std::string& written);

}  // namespace clast

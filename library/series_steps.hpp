#pragma once
/// Targets of a series of variations, as given by options, campaign files and Python.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "library/block_variation.hpp"

namespace clast {

/// Grid of shapes in a classification diagram (classify/form_grid.hpp).
struct FormGrid {
  std::string diagram = "sneed-folk";  ///< "sneed-folk" or "zingg"
  int steps = 10;
  double min_ratio = 0.2;  ///< minimum of S/L, or of I/L and S/I for zingg
};

/// Target values of a series of variations, any number of each kind.
struct VariationTargets {
  std::vector<BoxRatios> ratios;
  std::optional<FormGrid> grid;
  std::vector<double> convexity;
  std::vector<double> rounding;  ///< ratios of radius to S
  std::vector<double> roundness;
  double roundness_edge = kDefaultRoundnessEdge;
  std::vector<std::size_t> vertices;
  std::vector<double> detail;  ///< gains of the detail
  int degree = 6;              ///< degree of the detail
  std::vector<std::string> reference;
  double exponent = 4.0;  ///< exponent of superellipsoids
  std::vector<std::string> inertia;

  /// Returns the variations in the order of the members.
  /// @throws InputError  if a diagram or reference shape is unknown, or if `sneed_folk_grid` throws
  std::vector<Variation> variations() const;
};

/// Returns the names of the diagrams of `FormGrid`; `inertia_body_names` returns those of the
/// bodies of `InertiaVariation`.
const std::vector<std::string>& form_grid_diagram_names();
const std::vector<std::string>& inertia_body_names();

/// Checks the target ratios of a stretch.
/// @param written  ratios as written, for the message
/// @throws InputError  if they are not I/L and S/L of a box, both from 0.01 to 1
BoxRatios check_stretch_ratios(double i_over_l, double s_over_l, const std::string& written);

}  // namespace clast

#pragma once
/// Measurements of a block that shape classes and population statistics need.
#include <optional>
#include <string>
#include <vector>

#include "classify/form.hpp"

namespace clast {

struct MeasuredBlock {
  std::string name;
  Axes axes;                   ///< m
  Axes axes_as_written;        ///< sorted, in the unit of the table, so that their ratios have no
                               ///< rounding error from a unit conversion
  std::optional<double> mass;  ///< kg
  double axis_error = 0.0;     ///< error bound of each axis, m
  std::vector<Axes>
      axes_by_box;  ///< m, by each of `kBoxConventions`; empty for axes measured by tape
  /// The unit of the lengths is unknown: the block has a form, but neither size nor mass.
  bool unscaled = false;
};

/// Makes a block from axes that were measured in metres.
inline MeasuredBlock make_measured_block(std::string name, const Axes& axes,
                                         std::optional<double> mass = std::nullopt) {
  return {std::move(name), axes, axes, mass, 0.0, {}, false};
}

}  // namespace clast

#pragma once
/// A block as far as classes and populations need it.
#include <optional>
#include <string>
#include <vector>

#include "classify/form.hpp"

namespace clast {

struct MeasuredBlock {
  std::string name;
  Axes axes;        ///< m
  Axes axes_as_written;  ///< sorted, in the unit of the table; ratios of these carry no rounding of the
                    ///< unit
  std::optional<double> mass;  ///< kg
  double axis_error = 0.0;     ///< m; each axis may be off by so much
  std::vector<Axes> axes_by_box;    ///< m; by each of `kBoxConventions`; empty for axes measured by tape
  /// Lengths above are in a unit that nobody knows: the block has a shape, but no size and no mass.
  bool unscaled = false;
};

/// Axes that were in metres from the start.
inline MeasuredBlock make_measured_block(std::string name, const Axes& axes,
                                    std::optional<double> mass = std::nullopt) {
  return {std::move(name), axes, axes, mass, 0.0, {}, false};
}

}  // namespace clast

#pragma once
/// Measurements of a block from which shape classes and population statistics are computed.
#include <optional>
#include <string>
#include <vector>

#include "classify/deposit_observation.hpp"
#include "classify/form.hpp"

namespace clast {

struct MeasuredBlock {
  std::string name;
  Axes axes;                ///< m
  Axes axes_in_table_unit;  ///< sorted axes in the unit of the table, whose ratios have no rounding
                            ///< error from a unit conversion
  std::optional<double> mass;  ///< kg
  double axis_error = 0.0;     ///< error bound of each axis, m
  std::vector<Axes>
      axes_by_box;  ///< axes for each of `kBoxConventions`, m; empty if measured by tape
  /// True if the unit of the lengths is unknown, so that the block has neither size nor mass.
  bool unscaled = false;
  std::optional<DepositObservation> deposit = {};  ///< empty if the block is not of a deposit
};

/// Makes a block from axes that were measured in metres.
inline MeasuredBlock make_measured_block(std::string name, const Axes& axes,
                                         std::optional<double> mass = std::nullopt) {
  return {std::move(name), axes, axes, mass, 0.0, {}, false, {}};
}

}  // namespace clast

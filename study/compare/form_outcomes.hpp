#pragma once
/// Outcomes by block form.
#include <cstdint>
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Mean outcome of the runs of one block form.
struct ShapeOutcome {
  std::string form;  ///< id of the library block
  Axes axes;
  bool made = false;  ///< true for forms made by `clast vary`, false for scanned blocks
  std::size_t runs = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation over the runs
};

/// One outcome by form, for a file with at least six forms.
struct OutcomeByShape {
  std::uint32_t file = 0;
  std::string outcome;  ///< "runout", "lateral angle", "largest energy", or "passing BARRIER"
  std::string unit;
  std::vector<ShapeOutcome> forms;  ///< ordered by name
};

/// Computes the outcomes by form over all runs, which count with their last position. Empty for
/// files with persistent blocks.
std::vector<OutcomeByShape> compute_outcomes_by_shape(const Comparison& comparison);

}  // namespace clast

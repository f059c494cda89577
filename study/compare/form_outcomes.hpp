#pragma once
/// What the runs of each form of a campaign came to.
#include <cstdint>
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// What the runs of one form came to.
struct ShapeOutcome {
  std::string form;  ///< block of the library
  Axes axes;
  bool made = false;  ///< stretched to this form (`clast vary`), not a scanned block
  std::size_t runs = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation of the runs
};

/// One outcome of a file with six forms or more.
struct OutcomeByShape {
  std::uint32_t file = 0;
  std::string outcome;  ///< "runout", "lateral angle", "largest energy", or "passing BARRIER"
  std::string unit;
  std::vector<ShapeOutcome> forms;  ///< by name
};

/// Over all runs of each form, where they ended; none of files whose blocks stay.
std::vector<OutcomeByShape> compute_outcomes_by_shape(const Comparison& comparison);

}  // namespace clast

#pragma once
/// The ground parameters, each declared once: campaign files, results files, tables and pages have
/// them from here.
#include <span>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

/// A parameter of a ground zone.
struct GroundField {
  const char* name;     ///< in campaign files, results and tables, with its unit
  const char* unit;     ///< empty: a pure number
  const char* meaning;  ///< by its symbol in the formulas, "mu"
  const char* heading;  ///< of a column on pages
  const char* words;    ///< in a sentence, "rolling friction"
  NumberRange range;
  bool required;  ///< of every zone; else 0 where it is not stated
  bool of_soil;   ///< what blocks do to each other has none
  double GroundParameters::*value;
  std::optional<Uncertain> GroundTable::*asked;
};

/// In the order of the columns.
std::span<const GroundField> ground_fields();

}  // namespace clast

#pragma once
/// Declarations of the ground parameters, used by campaign files, results files, tables and pages.
#include <span>
#include <string>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

struct GroundParameterField {
  const char* name;     ///< in campaign files, results and tables, with unit
  const char* unit;     ///< empty if dimensionless
  const char* meaning;  ///< with its symbol in the formulas, "mu"
  const char* heading;  ///< of the column on pages
  const char* words;    ///< name in a sentence, "rolling friction"
  NumberRange range;
  bool required;  ///< must be stated for each zone; otherwise the default is 0
  /// True for parameters of the soil, which are experimental because no measurement supports them.
  /// They do not exist between blocks.
  bool of_soil;
  double GroundParameters::*value;
  std::optional<Distribution> GroundDistributions::*asked;

  /// Returns the description shown by editors.
  std::string explanation() const;
};

/// Returns all parameters in column order, soil parameters last.
std::span<const GroundParameterField> ground_fields();

}  // namespace clast

#pragma once
/// Declarations of the ground parameters, used by campaign files, results files, tables and pages.
#include <span>
#include <string>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

struct GroundParameterField {
  const char* name;     ///< name with unit in campaign files, results and tables
  const char* unit;     ///< empty if dimensionless
  const char* meaning;  ///< description with the symbol in formulas, such as "mu"
  const char* heading;  ///< heading of the column on pages
  const char* words;    ///< name in a sentence, such as "rolling friction"
  NumberRange range;
  bool required;  ///< true if it must be stated for each zone; otherwise, the default is 0
  /// True for parameters of the soil. They are experimental, because no measurement supports them.
  /// They do not apply between blocks.
  bool is_soil_parameter;
  double GroundParameters::*value;
  std::optional<Distribution> GroundDistributions::*distribution;

  /// Returns the description shown by editors.
  std::string explanation() const;
};

/// Returns all parameters in column order, soil parameters last.
std::span<const GroundParameterField> ground_parameter_fields();

}  // namespace clast

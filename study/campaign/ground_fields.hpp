#pragma once
/// Declarations of the ground parameters for campaign files, results files, tables and pages.
#include <span>
#include <string>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

struct GroundParameterField {
  const char* name;     ///< name with unit, such as "rolling_length_m"
  const char* unit;     ///< empty if dimensionless
  const char* meaning;  ///< description with the symbol in formulas, such as "mu"
  const char* heading;  ///< heading of the column on pages
  const char* words;    ///< name in a sentence, such as "rolling friction"
  NumberRange range;
  bool required;  ///< true if it must be stated for each zone; otherwise, the default is 0
  /// True for experimental parameters of the soil. They do not apply between blocks.
  bool is_soil_parameter;
  double GroundParameters::*value;
  std::optional<Distribution> GroundDistributions::*distribution;

  /// Returns the description of the parameter that editors show.
  std::string explanation() const;
};

/// Returns the declarations of all ground parameters, soil parameters last.
std::span<const GroundParameterField> ground_parameter_fields();

}  // namespace clast

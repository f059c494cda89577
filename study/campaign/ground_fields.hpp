#pragma once
/// The ground parameters, each declared once: campaign files, results files, tables and pages have
/// them from here.
#include <span>
#include <string>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

/// A parameter of a ground zone.
struct GroundParameterField {
  const char* name;     ///< in campaign files, results and tables, with its unit
  const char* unit;     ///< empty: a pure number
  const char* meaning;  ///< by its symbol in the formulas, "mu"
  const char* heading;  ///< of a column on pages
  const char* words;    ///< in a sentence, "rolling friction"
  NumberRange range;
  bool required;  ///< of every zone; else 0 where it is not stated
  /// What the soil does: experimental, since no measurement supports its values. What blocks do to
  /// each other has none of it.
  bool of_soil;
  double GroundParameters::*value;
  std::optional<Distribution> GroundDistributions::*asked;

  /// What an editor says of the key.
  std::string explanation() const;
};

/// In the order of the columns; those of the soil last.
std::span<const GroundParameterField> ground_fields();

}  // namespace clast

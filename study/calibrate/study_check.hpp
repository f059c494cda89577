#pragma once
/// Whether a calibration would begin.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/calibrate/calibration_study.hpp"

namespace clast {

struct CalibrationCheck {
  /// Why it would be refused: the first finding in each table of the study, and all that
  /// `check_campaign` finds in the campaigns of its sites. Empty: it would begin.
  std::vector<std::string> findings;
  std::optional<CalibrationStudy> study;  ///< there when it would begin
};

/// Never throws for what is wrong with the study or with the files it names.
CalibrationCheck check_calibration_study(const std::filesystem::path& file);

}  // namespace clast

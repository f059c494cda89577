#pragma once
/// Check of a calibration study without running it.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/calibrate/calibration_study.hpp"

namespace clast {

struct CalibrationCheck {
  /// Errors: the first one of each table of the study, and all that `check_campaign` finds in the
  /// campaigns of its sites. Empty if the calibration would start.
  std::vector<std::string> findings;
  std::optional<CalibrationStudy> study;  ///< set if the calibration would start
};

/// Checks a study file. Errors of the study and of the files that it names are returned, not
/// thrown.
CalibrationCheck check_calibration_study(const std::filesystem::path& file);

}  // namespace clast

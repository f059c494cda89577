#pragma once
/// Check of a calibration study without running it.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/calibrate/calibration_study.hpp"

namespace clast {

struct CalibrationCheck {
  /// Errors of the study and of the campaigns of its sites, which prevent the calibration from
  /// starting.
  std::vector<std::string> findings;
  std::optional<CalibrationStudy> study;  ///< checked study; empty if there are errors
};

/// Checks a study file. Errors in the study and in files that it names are returned, not thrown.
CalibrationCheck check_calibration_study(const std::filesystem::path& file);

}  // namespace clast

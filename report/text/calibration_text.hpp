#pragma once
/// Texts and text tables of a calibration.
#include <string>
#include <vector>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Formats a study: sites, members and runs, unknowns with ranges, and observed statistics.
std::string format_study_summary(const CalibrationStudy& study);

/// Describes an unknown, such as "friction of blue" or "rolling length of scree, m".
std::string describe_unknown(const std::string& parameter);

/// Describes the result in a sentence, which states the determined parameters and their values.
std::string describe_calibration_result(const Calibration& calibration);
/// Describes the quality of fit and prediction, correlations, and warnings.
std::vector<std::string> describe_calibration_findings(const Calibration& calibration);

/// Formats a table with prior, median, 95 % interval and relative width of each unknown.
std::string format_unknowns_table(const Calibration& calibration);
/// Formats a table of observed and predicted statistics, 95 % intervals and surrogate quality.
std::string format_statistics_table(const Calibration& calibration);

/// Formats tables [ground.NAME] with the posterior medians, for use in campaign files.
std::string format_ground_tables(const Calibration& calibration);

}  // namespace clast

#pragma once
/// Texts and text tables of a calibration.
#include <string>
#include <vector>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Formats sites, members and runs, unknowns with ranges, and observed statistics of a study.
std::string format_study_summary(const CalibrationStudy& study);

/// Describes an unknown: "friction of blue", "rolling length of scree, m", "height of release, m".
std::string describe_unknown(const std::string& parameter);

/// Describes the result in a sentence: the parameters that are determined, and their values.
std::string describe_calibration_result(const Calibration& calibration);
/// Describes whether fit and prediction hold, correlations, and warnings.
std::vector<std::string> describe_calibration_findings(const Calibration& calibration);

/// Formats prior, median, 95 % interval and relative width of each unknown.
std::string format_unknowns_table(const Calibration& calibration);
/// Formats the observed and predicted statistics with 95 % intervals and the quality of the
/// surrogates.
std::string format_statistics_table(const Calibration& calibration);

/// Formats the tables [ground.NAME] for campaigns with the posterior medians.
std::string format_ground_block(const Calibration& calibration);

}  // namespace clast

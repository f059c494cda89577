#pragma once
/// Descriptions of a calibration and its results, as sentences and text tables.
#include <string>
#include <vector>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Formats a calibration study as text: sites, members, unknown parameters with ranges, and
/// observed statistics.
std::string format_study_summary(const CalibrationStudy& study);

/// Describes an unknown, such as "friction of blue" or "rolling length of scree, m".
std::string describe_unknown(const std::string& parameter);

/// Describes the result of a calibration in a sentence: determined parameters and their values.
std::string describe_calibration_result(const Calibration& calibration);
/// Describes the quality of fit and prediction of a calibration, correlations and warnings.
std::vector<std::string> describe_calibration_findings(const Calibration& calibration);

/// Formats a text table with prior, median and 95 % interval of each unknown parameter.
std::string format_unknowns_table(const Calibration& calibration);
/// Formats a text table of observed and predicted statistics.
std::string format_statistics_table(const Calibration& calibration);

/// Formats the posterior medians of ground parameters as tables [ground.NAME] for campaign files.
std::string format_ground_tables(const Calibration& calibration);

}  // namespace clast

#pragma once
/// A calibration in words, and as tables of text.
#include <string>
#include <vector>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// What a study asks: sites, members and runs; unknowns with their ranges; observed figures.
std::string format_study_summary(const CalibrationStudy& study);

/// "friction of blue", "rolling length of scree, m", "height of release, m".
std::string describe_unknown(const std::string& parameter);

/// The answer in a sentence: which parameters the observations tell, and what they are.
std::string describe_calibration_result(const Calibration& calibration);
/// Then whether fit and prediction hold, ridges, and what a reader must know.
std::vector<std::string> describe_calibration_findings(const Calibration& calibration);

/// Unknowns: prior, median, 95 % interval, how much of the prior's width is left.
std::string format_unknowns_table(const Calibration& calibration);
/// Figures: observed, predicted with its 95 % interval, what the surrogate explains.
std::string format_statistics_table(const Calibration& calibration);

/// Tables [ground.NAME] for campaigns with the medians found, other values as in the campaigns.
std::string format_ground_block(const Calibration& calibration);

}  // namespace clast

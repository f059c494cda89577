#pragma once
/// Part-by-part reading of a study file.
#include <filesystem>

#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/campaign_reading.hpp"

namespace clast::study_detail {

/// Reads a study part by part through `read`. If one fails, dependent parts are skipped.
CalibrationStudy read_study_by_parts(const std::filesystem::path& file, const PartReader& read);

}  // namespace clast::study_detail

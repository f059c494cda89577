#pragma once
/// Reading of a calibration study by parts.
#include <filesystem>

#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/campaign_reading.hpp"

namespace clast::study_detail {

/// Reads a study file by parts. `read` runs the reader of each part; if it fails, dependent parts
/// are skipped.
CalibrationStudy read_study_by_parts(const std::filesystem::path& file, const PartReader& read);

}  // namespace clast::study_detail

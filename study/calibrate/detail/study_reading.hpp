#pragma once
/// The parts of a study file, read and checked.
#include <filesystem>

#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/campaign_reading.hpp"

namespace clast::study_detail {

/// A study, read part by part through `read`; a part that needs another is left out where that one
/// was not read.
CalibrationStudy read_study_in_parts(const std::filesystem::path& file, const PartReader& read);

}  // namespace clast::study_detail

#pragma once
/// The simulations of a calibration's members: which are missing, who simulates them, and how they
/// are kept.
#include <string>
#include <vector>

#include "study/calibrate/calibrate.hpp"

namespace clast::study_detail {

/// Simulates the members of the shard that are missing and keeps them beside the target; whatever
/// ends it, what was simulated is kept.
/// @param stored  gets them
/// @throws SimulationError  a member whose runs fail, here or in another process
void simulate_missing_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                      const std::filesystem::path& target, const CalibrateOptions& options,
                      StoredCalibration& stored);

/// Simulates what `simulate_missing_members` of the process that leads hands out.
void follow_missing(const CalibrationStudy& study, const CalibrationBackend& simulator,
                    ProcessTeam& team);

/// Outcomes as bytes, and back.
std::string serialize_outcomes(const std::vector<ReleaseOutcome>& outcomes);
std::vector<ReleaseOutcome> deserialize_outcomes(const std::string& bytes);

}  // namespace clast::study_detail

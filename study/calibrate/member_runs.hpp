#pragma once
/// Simulation and storage of a calibration's members.
#include <string>
#include <vector>

#include "study/calibrate/calibrate.hpp"

namespace clast::study_detail {

/// Simulates the missing members of the shard and stores them beside the target; finished members
/// are kept if it is interrupted.
/// @param stored  receives the members
/// @throws SimulationError  if a member's runs fail, here or in another process
void simulate_missing_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                              const std::filesystem::path& target, const CalibrateOptions& options,
                              StoredCalibration& stored);

void simulate_received_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                               ProcessTeam& team);

std::string serialize_outcomes(const std::vector<ReleaseOutcome>& outcomes);
std::vector<ReleaseOutcome> deserialize_outcomes(const std::string& bytes);

}  // namespace clast::study_detail

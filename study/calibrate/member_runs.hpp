#pragma once
/// Simulation and storage of a calibration's members.
#include <string>
#include <vector>

#include "study/calibrate/calibrate.hpp"

namespace clast::study_detail {

/// Simulates the missing members of the shard and stores them in a journal beside the target.
/// Finished members are kept if the simulation is interrupted.
/// @param stored  stored members; receives the new ones
/// @throws SimulationError  if a member's runs fail, here or in another process
void simulate_missing_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                              const std::filesystem::path& target,
                              const CalibrationOptions& options, StoredCalibration& stored);

void simulate_received_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                               ProcessTeam& team);

std::string serialize_outcomes(const std::vector<ReleaseOutcome>& outcomes);
std::vector<ReleaseOutcome> deserialize_outcomes(const std::string& bytes);

}  // namespace clast::study_detail

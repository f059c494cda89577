#pragma once
/// Simulation and storage of the members of a calibration.
#include <string>
#include <vector>

#include "study/calibrate/calibrate.hpp"

namespace clast::study_detail {

/// Simulates the members that are not stored yet, and stores them in a journal beside the target.
/// Finished members are kept if the simulation is interrupted.
/// @param stored  stored members, to which the new ones are added
/// @throws SimulationError  if a member's runs fail, here or in another process
void simulate_missing_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                              const std::filesystem::path& target,
                              const CalibrationOptions& options, StoredCalibration& stored);

void simulate_received_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                               ProcessTeam& team);

std::string serialize_outcomes(const std::vector<ReleaseOutcome>& outcomes);
std::vector<ReleaseOutcome> deserialize_outcomes(const std::string& bytes);

}  // namespace clast::study_detail

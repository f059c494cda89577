#pragma once
/// Counts of stop reasons and quality measures over all runs of a campaign.
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/results/results.hpp"

namespace clast {

/// Stop reasons in the order of `StopReasonCounts::reasons`.
inline constexpr std::array<StopReason, 4> kStopReasons = {
    StopReason::kRest, StopReason::kLeftTerrain, StopReason::kMaxTime, StopReason::kError};

/// Number of runs by stop reason, and quality measures over all runs.
struct StopReasonCounts {
  /// Number of runs with each stop reason of `kStopReasons`.
  std::array<std::size_t, 4> reasons = {};
  std::size_t below_ground = 0;
  std::optional<double> largest_energy_error;  ///< empty if contacts were not recorded
  std::size_t reassigned = 0;                  ///< number of runs with a large reassigned energy
  std::optional<double> largest_reassigned;
  std::string first_error;

  std::size_t errors() const { return reasons.back(); }
};

StopReasonCounts count_stop_reasons(const CampaignResults& results);

/// Returns warnings about failed and implausible runs, one sentence each.
std::vector<std::string> describe_failed_runs(const StopReasonCounts& outcome);

/// Checks that no run failed.
/// @param file  results file named in the message
/// @throws SimulationError  if any run ended with an error
void check_no_failed_runs(const CampaignResults& results, const std::filesystem::path& file);

}  // namespace clast

#pragma once
/// What came out of a campaign, over all runs.
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/results/results.hpp"

namespace clast {

inline constexpr std::array<StopReason, 4> kStopReasons = {
    StopReason::kRest, StopReason::kLeftTerrain, StopReason::kMaxTime, StopReason::kError};

struct StopReasonCounts {
  std::array<std::size_t, 4> reasons = {};  ///< runs by `kStopReasons`
  std::size_t below_ground = 0;
  std::optional<double> largest_energy_error;  ///< none where contacts are not known
  std::size_t reassigned = 0;                  ///< runs above `kNotableReassigned`
  std::optional<double> largest_reassigned;
  std::string first_error;

  std::size_t errors() const { return reasons.back(); }
};

StopReasonCounts count_stop_reasons(const CampaignResults& results);

/// What must be known of the runs, in sentences.
std::vector<std::string> describe_failed_runs(const StopReasonCounts& outcome);

/// All runs are kept, but a campaign with failed ones has failed.
/// @param file  that holds the results
/// @throws SimulationError  any run ended with an error
void check_outcome(const CampaignResults& results, const std::filesystem::path& file);

}  // namespace clast

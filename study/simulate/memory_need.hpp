#pragma once
/// Memory needed by realisations of persistent blocks.
#include <cstddef>
#include <optional>
#include <string>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Estimates the memory of the first realisation during its simulation, in addition to the prepared
/// campaign, bytes: by block vertices and stored states. 0 for single runs.
double estimate_realisation_memory(const CampaignPlan& prepared);

/// Checks that the realisations fit into memory.
/// @param at_a_time  number of realisations simulated at the same time
/// @param available  bytes; empty if unknown, then nothing is checked
/// @throws InputError  if they need more; names the needed and the free memory and what to change
void check_memory(const CampaignPlan& prepared, std::size_t at_a_time,
                  std::optional<double> available);

/// Formats a number of bytes: "1.3 GB", "45 MB".
std::string format_memory(double bytes);

}  // namespace clast

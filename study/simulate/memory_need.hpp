#pragma once
/// Estimate of the memory that realisations of persistent blocks need.
#include <cstddef>
#include <optional>
#include <string>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Estimates the memory that a realisation of persistent blocks needs, bytes; 0 for single-block
/// runs.
double estimate_realisation_memory(const CampaignPlan& prepared);

/// Checks that the realisations fit into memory.
/// @param at_a_time  number of realisations simulated at the same time
/// @param available  free memory, bytes; if empty, nothing is checked
/// @throws InputError  if more memory is needed; states the needed and the free memory, and advice
void check_free_memory(const CampaignPlan& prepared, std::size_t at_a_time,
                       std::optional<double> available);

/// Formats a number of bytes, such as "1.3 GB" or "45 MB".
std::string format_memory(double bytes);

}  // namespace clast

#pragma once
/// How much memory blocks that stay take.
#include <cstddef>
#include <optional>
#include <string>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// About what the first realisation takes while it is simulated, in addition to the prepared
/// campaign, bytes: by the vertices of its blocks, and by the states that are stored of them. 0
/// where blocks are run one by one.
double estimate_realisation_memory(const CampaignPlan& prepared);

/// @param at_a_time  realisations that are simulated at the same time
/// @param available  bytes; none where that is not known, and nothing is refused
/// @throws InputError  they need more than is available; the message says how much is needed and
///                     free, and what to change
void check_memory(const CampaignPlan& prepared, std::size_t at_a_time,
                  std::optional<double> available);

/// "1.3 GB", "45 MB".
std::string format_memory(double bytes);

}  // namespace clast

#include "study/simulate/memory_need.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

/// Bytes of a block, with its contacts, and of each vertex: at least 1.5 times what was measured in
/// piles of 500 rocks of 12 to 642 vertices (docs/benchmarks.md).
constexpr double kOfBlock = 24e3, kOfVertex = 0.19e3;
/// Bytes of a stored state: time, position, orientation, velocity and spin.
constexpr double kOfState = 14.0 * sizeof(double);

}  // namespace

double estimate_realisation_memory(const CampaignPlan& prepared) {
  if (!prepared.header.persistent_blocks) return 0.0;
  const Campaign& campaign = prepared.campaign;
  const std::size_t blocks = prepared.header.persistent_blocks->blocks_per_realisation;
  double bytes = 0.0;
  for (std::size_t i = 0; i < blocks; ++i) {
    const CampaignBlock& block = prepared.choice.blocks[prepared.runs[i].block];
    const std::size_t vertices = prepared.choice.library[block.library].body.vertices.size();
    bytes += kOfBlock + kOfVertex * static_cast<double>(vertices);
  }
  if (campaign.trajectory_interval > 0.0) {
    const double longest = prepared.header.persistent_blocks->at_once
                               ? campaign.max_time + campaign.persistent_blocks->last_release_time()
                               : campaign.max_time;
    bytes += kOfState * static_cast<double>(blocks) * longest / campaign.trajectory_interval;
  }
  return bytes;
}

void check_free_memory(const CampaignPlan& prepared, std::size_t at_a_time,
                       std::optional<double> available) {
  const double each = estimate_realisation_memory(prepared);
  const double all = each * static_cast<double>(at_a_time);
  if (!available || all <= *available) return;
  const std::string blocks =
      format_count(at_a_time, "realisation") + " of " +
      format_count(prepared.header.persistent_blocks->blocks_per_realisation, "block") +
      (at_a_time > 1 ? " at a time need about " : " needs about ");
  throw InputError(
      prepared.campaign.file.string() + ": " + blocks + format_memory(all) + " of memory, but " +
      format_memory(*available) + " is free; use " +
      (each <= *available ? "fewer threads" : "fewer blocks, or blocks with fewer vertices") +
      (prepared.campaign.trajectory_interval > 0.0 ? ", or a longer trajectory_interval_s" : ""));
}

std::string format_memory(double bytes) {
  return bytes >= 0.95e9 ? format_significant(bytes / 1e9, 2) + " GB"
                         : format_decimals(std::max(1.0, bytes / 1e6), 0) + " MB";
}

}  // namespace clast

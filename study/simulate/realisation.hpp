#pragma once
/// Simulation of single runs and of realisations.
#include <vector>

#include "dem/simulation/sequence.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Simulates one run, or all runs of a realisation of persistent blocks. If it fails, all runs of
/// the realisation are stored with stop reason `error` and the message.
/// @param first  index of the first run
/// @param after_step  called after each step and flight; an exception ends the run
/// @param threads  number of threads for a realisation
/// @param observe  called with the motion of a single run; not called for persistent blocks
/// @param from  saved state of the same realisation (`SequenceProgress::save`), which is continued
///              bit-identically; null to start from the beginning
/// @throws InputError  if the saved state is of another realisation
std::vector<StoredRun> simulate_realisation(const CampaignPlan& prepared, std::uint32_t first,
                                            const SequenceProgressObserver& after_step = {},
                                            unsigned threads = 1,
                                            const MotionObserver& observe = {},
                                            ByteReader* from = nullptr);

/// Checks that no blocks of a multi-block release overlap at the start.
/// @param first  index of the first run
/// @throws SimulationError  if two blocks overlap; names their ids and the overlap
void check_multi_block_start(const CampaignPlan& prepared, std::uint32_t first);

}  // namespace clast::study_detail

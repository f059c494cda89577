#pragma once
/// Simulation of single runs and of realisations.
#include <vector>

#include "dem/simulation/sequence.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Simulates one run, or all runs of a realisation of persistent blocks. If the simulation fails,
/// the returned runs have the stop reason kError and the message.
/// @param first  index of the first run
/// @param after_step  function called after each step and flight; an exception ends the run
/// @param threads  number of threads for a realisation
/// @param observe  observer of the motion of a single block; not called for persistent blocks
/// @param from  saved state from which the realisation continues; null to start from the beginning
/// @throws InputError  if the saved state is of another realisation
std::vector<StoredRun> simulate_realisation(const CampaignPlan& prepared, std::uint32_t first,
                                            const SequenceProgressObserver& after_step = {},
                                            unsigned threads = 1,
                                            const MotionObserver& observe = {},
                                            ByteReader* from = nullptr);

/// Checks that no blocks that are released at once overlap at the start.
/// @param first  index of the first run
/// @throws SimulationError  if two blocks overlap; names their ids and the overlap
void check_multi_block_start(const CampaignPlan& prepared, std::uint32_t first);

}  // namespace clast::study_detail

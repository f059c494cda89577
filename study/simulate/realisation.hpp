#pragma once
/// Computation of single runs and of realisations.
#include <vector>

#include "dem/simulation/sequence.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Computes one run, or all runs of a realisation of persistent blocks. A failure is stored with
/// stop reason `error` and its message, for all runs of a realisation.
/// @param first  index of the first run
/// @param after_step  called after each step and flight; its exceptions end the run
/// @param threads  for a realisation
/// @param observe  receives the motion of a single run; not called for persistent blocks
/// @param from  state of the same realisation saved by the same program (`SequenceProgress::save`),
///              continued bit-identically; null: none
/// @throws InputError  if the saved state is of another realisation
std::vector<StoredRun> simulate_realisation(const CampaignPlan& prepared, std::uint32_t first,
                                            const SequenceProgressObserver& after_step = {},
                                            unsigned threads = 1,
                                            const MotionObserver& observe = {},
                                            ByteReader* from = nullptr);

/// Checks that no blocks of a multi-block release overlap at the start.
/// @param first  index of its first run
/// @throws SimulationError  if two overlap; names their ids and the overlap
void check_mass_start(const CampaignPlan& prepared, std::uint32_t first);

}  // namespace clast::study_detail

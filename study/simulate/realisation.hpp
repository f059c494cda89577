#pragma once
/// Runs of a campaign that are computed together.
#include <vector>

#include "dem/simulation/sequence.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Runs one run, or all of a realisation of blocks that stay. What fails is stored with stop reason
/// `error` and its message, a realisation as a whole.
/// @param first       number of the first of these runs
/// @param after_step  called after every step and flight; what it throws ends the run
/// @param threads     that a realisation may use
/// @param observe     sees the motion of a single run; nothing of blocks that stay
/// @param from        a state of the same realisation, saved by the same program
///                    (`SequenceProgress::save`), to continue from to the same bits; null: none
/// @throws InputError  the saved state is not of this realisation
std::vector<StoredRun> runs_from(const CampaignPlan& prepared, std::uint32_t first,
                                 const SequenceProgressObserver& after_step = {},
                                 unsigned threads = 1, const MotionObserver& observe = {},
                                 ByteReader* from = nullptr);

/// Makes sure that no two blocks of a mass overlap at the start, so that it can run.
/// @param first  number of the first of its runs
/// @throws SimulationError  two do: their ids and how deep
void check_mass_start(const CampaignPlan& prepared, std::uint32_t first);

}  // namespace clast::study_detail

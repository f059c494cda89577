#pragma once
/// Runs a campaign.
#include <functional>
#include <vector>

#include "library/block_library.hpp"
#include "study/campaign.hpp"
#include "study/results.hpp"

namespace clast {

/// A campaign with its inputs loaded and everything decided: what would run, and how.
struct PreparedCampaign {
  Campaign campaign;
  CampaignResults header;             ///< no runs yet
  std::vector<Block> blocks;
  std::vector<RigidBody> bodies;      ///< of `blocks`
  StiffnessChoice stiffness;
  ReleaseSettings settings;
  /// Planned runs in order: blocks, then points, then orientations (fastest).
  std::vector<RunRecord> runs;        ///< `result` still empty
};

/// Loads library and terrain, places every block and checks every start.
/// @throws InputError       inputs that do not fit: a zone without parameters, a parameter for no
///                          zone, no block selected, a point off the terrain
/// @throws SimulationError  a start inside the ground: block, point, orientation and depth
PreparedCampaign prepare_campaign(const Campaign& campaign);

struct RunOptions {
  unsigned threads = 0;   ///< 0: one per core
  bool resume = false;    ///< go on with an interrupted campaign
  /// Called after each run with runs done and planned, from any thread, one at a time.
  std::function<void(std::size_t done, std::size_t planned)> progress;
};

/// Runs everything that is not stored yet and writes `target`. A run that fails is stored with stop
/// reason `error` and its message.
void run_campaign(const PreparedCampaign& prepared, const std::filesystem::path& target,
                  const RunOptions& options = {});

}  // namespace clast

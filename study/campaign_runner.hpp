#pragma once
/// Runs a campaign.
#include <functional>
#include <optional>
#include <vector>

#include "library/block_library.hpp"
#include "study/campaign.hpp"
#include "study/results.hpp"

namespace clast {

/// A campaign with its inputs loaded and everything decided: what would run, and how.
struct PreparedCampaign {
  Campaign campaign;
  CampaignResults header;  ///< no runs yet
  std::vector<Block> blocks;
  std::vector<RigidBody> bodies;          ///< of `blocks`
  std::optional<TerrainSurface> surface;  ///< of `header.terrain`; always there
  StiffnessChoice stiffness;
  ReleaseSettings settings;
  /// Planned runs in order: blocks, then points, then orientations (fastest).
  std::vector<RunRecord> runs;  ///< `result` still empty
};

/// A block as the dynamics sees it.
RigidBody rigid_body(const Block& block);

/// Loads library and terrain, places every block and checks every start.
/// @throws InputError       inputs that do not fit: a zone without parameters, a parameter for no
///                          zone, no block selected, a point off the terrain
/// @throws SimulationError  a start inside the ground: block, point, orientation and depth
PreparedCampaign prepare_campaign(const Campaign& campaign);

struct RunOptions {
  unsigned threads = 0;  ///< 0: one per core
  /// Goes on with an interrupted campaign; begins when there is none. Otherwise what an interrupted
  /// one left is replaced.
  bool resume = false;
  /// Called after each run with runs done and planned, from any thread, one at a time.
  std::function<void(std::size_t done, std::size_t planned)> progress = {};
};

/// Runs everything that is not stored yet and writes `target`. A run that fails is stored with stop
/// reason `error` and its message. The datasets do not depend on the number of threads or on
/// interruptions.
/// @throws InputError  the target can't be written, or resuming what another campaign began
void run_campaign(const PreparedCampaign& prepared, const std::filesystem::path& target,
                  const RunOptions& options = {});

}  // namespace clast

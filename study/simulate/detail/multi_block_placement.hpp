#pragma once
/// Start positions of the blocks of simultaneous releases.
#include <string>
#include <vector>

#include "core/random.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "study/simulate/detail/block_packing.hpp"
#include "study/simulate/detail/measured_bodies.hpp"

namespace clast::study_detail {

/// Places the blocks of a realisation one by one, at their library positions or on a heap.
class MultiBlockPlacement {
 public:
  /// Makes empty heaps for all simultaneous releases.
  /// @param prepared  plan with campaign, blocks, terrain and header; must outlive this object
  /// @throws InputError  if a polygon has no area, leaves the terrain, or overlaps another
  explicit MultiBlockPlacement(const CampaignPlan& prepared);

  /// Starts a realisation.
  /// @param name  name of the realisation, which seeds the orientations
  /// @param blocks  number of blocks of each release
  void begin(const std::string& name, const std::vector<std::size_t>& blocks);
  /// Places one block.
  /// @param body  body of the block
  /// @throws InputError  if there is no place for the block, or if it is outside the terrain
  /// @throws SimulationError  if its position is inside the ground
  RigidState place(std::size_t mass, std::uint32_t block, const GroundOverlapBody& body,
                   Random& random);
  /// Returns the initial state of each release, with all blocks placed since `begin`.
  std::vector<MultiBlockStart> placed() const;

 private:
  void check_no_overlapping_heaps() const;
  RigidState in_place_state(std::size_t mass, std::uint32_t block,
                            const GroundOverlapBody& body) const;
  RigidState sample_heap_start(std::size_t mass, std::uint32_t block, const GroundOverlapBody& body,
                               Random& random);
  [[noreturn]] void throw_no_place_for_block(std::size_t mass, std::uint32_t block) const;

  const CampaignPlan& prepared_;
  const std::vector<MultiBlockRelease>& plans_;
  std::vector<BlockPacking> packings_;  ///< packing of each heap
  std::string name_;
  std::vector<std::size_t> expected_;    ///< number of blocks of each release
  std::vector<MultiBlockStart> placed_;  ///< initial state of each release
};

}  // namespace clast::study_detail

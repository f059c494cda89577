#pragma once
/// Where the blocks of rock masses start.
#include <string>
#include <vector>

#include "core/random.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "study/simulate/detail/block_packing.hpp"
#include "study/simulate/detail/measured_bodies.hpp"

namespace clast::study_detail {

/// Places the blocks of one realisation after the other: where they lie in the frame of their
/// library, or on a heap.
class MultiBlockPlacement {
 public:
  /// @param prepared  with campaign, blocks, terrain and header; must outlive it
  /// @throws InputError  a polygon without area, beyond the terrain, or over that of another heap
  explicit MultiBlockPlacement(const CampaignPlan& prepared);

  /// Begins a realisation.
  /// @param name    that orientations are drawn by
  /// @param blocks  how many each mass will have
  void begin(const std::string& name, const std::vector<std::size_t>& blocks);
  /// @param body  of this block
  /// @throws InputError       the block fits nowhere, or its place is off the terrain
  /// @throws SimulationError  its place is inside the ground
  RigidState place(std::size_t mass, std::uint32_t block, const MeasuredBody& body, Random& random);
  /// What was placed of each mass since `begin`.
  std::vector<MultiBlockStart> placed() const;

 private:
  void check_no_common_space() const;
  RigidState in_place(std::size_t mass, std::uint32_t block, const MeasuredBody& body) const;
  RigidState place_in_heap(std::size_t mass, std::uint32_t block, const MeasuredBody& body,
                     Random& random);
  [[noreturn]] void refuse_block(std::size_t mass, std::uint32_t block) const;

  const CampaignPlan& prepared_;
  const std::vector<MultiBlockRelease>& plans_;
  std::vector<BlockPacking> packings_;  ///< of the heaps; none in place
  std::string name_;
  std::vector<std::size_t> expected_;  ///< blocks of each mass
  std::vector<MultiBlockStart> placed_;      ///< of each mass
};

}  // namespace clast::study_detail

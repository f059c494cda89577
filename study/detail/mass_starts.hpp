#pragma once
/// Where the blocks of a rock mass start.
#include <optional>
#include <string>

#include "core/random.hpp"
#include "study/campaign_runner.hpp"
#include "study/detail/block_packing.hpp"

namespace clast::study_detail {

/// Places the blocks of one realisation after the other: where they lie in the frame of their
/// library, or on a heap.
class MassStarts {
 public:
  /// @param prepared  with campaign, blocks, terrain and header; must outlive it
  /// @throws InputError  a polygon without area, or beyond the terrain
  explicit MassStarts(const PreparedCampaign& prepared);

  /// Begins a realisation.
  /// @param name  that orientations are drawn by
  void begin(const std::string& name);
  /// @param overlap  of this block with the ground
  /// @throws InputError       the block fits nowhere, or its place is off the terrain
  /// @throws SimulationError  its place is inside the ground
  RigidState place(std::uint32_t block, const GroundOverlap& overlap, Random& random);
  /// What was placed since `begin`.
  MassStart placed() const;

 private:
  RigidState in_place(std::uint32_t block, const GroundOverlap& overlap) const;
  RigidState on_heap(std::uint32_t block, const GroundOverlap& overlap, Random& random);
  [[noreturn]] void refuse_block(std::uint32_t block) const;

  const PreparedCampaign& prepared_;
  const MassPlan& plan_;
  std::optional<BlockPacking> packing_;  ///< of a heap
  std::string name_;
  std::size_t count_ = 0;  ///< placed
  MassStart placed_;
};

}  // namespace clast::study_detail

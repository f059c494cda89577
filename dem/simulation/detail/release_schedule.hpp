#pragma once
/// Release schedule of a simulation of several blocks: times at which blocks settle, are fixed, or
/// are released.
#include <cstddef>
#include <span>

#include "dem/simulation/sequence.hpp"

namespace clast::dem_detail {

class ReleaseSchedule {
 public:
  /// Stores references to blocks and settings.
  /// @param blocks  blocks of the simulation; must outlive this object, as must the settings
  ReleaseSchedule(std::span<const SequenceBlock> blocks, const SequenceSettings& settings)
      : blocks_(blocks), settings_(settings) {}

  /// True if a confining wall holds the block.
  bool is_confined(std::size_t block) const;
  bool starts_fixed(std::size_t block) const;
  /// Returns the time from the first release to the release of a block, s.
  double release_time(std::size_t block) const;

 private:
  std::span<const SequenceBlock> blocks_;
  const SequenceSettings& settings_;
};

}  // namespace clast::dem_detail

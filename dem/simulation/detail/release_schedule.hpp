#pragma once
/// Schedule of settling, fixed and released blocks of a sequence.
#include <cstddef>
#include <span>

#include "dem/simulation/sequence.hpp"

namespace clast::dem_detail {

class ReleaseSchedule {
 public:
  /// Stores references.
  /// @param blocks  must outlive this object, as must the settings
  ReleaseSchedule(std::span<const SequenceBlock> blocks, const SequenceSettings& settings)
      : blocks_(blocks), settings_(settings) {}

  /// True if a confining wall holds the block.
  bool is_confined(std::size_t block) const;
  bool starts_fixed(std::size_t block) const;
  /// Returns the release time of a block since the first release, s, for multi-block releases.
  double release_time(std::size_t block) const;

 private:
  std::span<const SequenceBlock> blocks_;
  const SequenceSettings& settings_;
};

}  // namespace clast::dem_detail

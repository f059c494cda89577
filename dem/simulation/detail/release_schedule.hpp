#pragma once
/// Which blocks of a sequence settle or are held before they are released, and until when.
#include <cstddef>
#include <span>

#include "dem/simulation/sequence.hpp"

namespace clast::dem_detail {

class ReleaseSchedule {
 public:
  /// @param blocks  they and the settings must outlive the schedule
  ReleaseSchedule(std::span<const SequenceBlock> blocks, const SequenceSettings& settings)
      : blocks_(blocks), settings_(settings) {}

  /// Does a form hold the block?
  bool is_confined(std::size_t block) const;
  /// Is the block held where it starts?
  bool starts_fixed(std::size_t block) const;
  /// Of blocks released at once: when the block is, since the first is, s.
  double release_time(std::size_t block) const;

 private:
  std::span<const SequenceBlock> blocks_;
  const SequenceSettings& settings_;
};

}  // namespace clast::dem_detail

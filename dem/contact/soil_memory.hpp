#pragma once
/// Dents that contacts left in the ground, for those that come later.
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/types.hpp"
#include "dem/contact/ground_parameters.hpp"

namespace clast::dem_detail {

/// Depths in square cells of the plan, of the ground zones that remember (docs/theory.md, Soil
/// memory). The deepest counts, so that no order of contacts changes what is remembered.
class SoilMemory {
 public:
  /// @param zones  their `soil_memory` is the width of their cells
  explicit SoilMemory(std::span<const GroundParameters> zones);

  /// Does any zone remember?
  bool is_enabled() const;
  bool empty() const { return depth_.empty(); }

  /// @return below the surface along its normal, m; 0 where nothing is remembered
  double residual_indentation(const Vec3& position, std::uint16_t zone) const;
  void add_indentation(const Vec3& position, std::uint16_t zone, double residual_indentation);
  /// Takes over all dents of the other, and leaves it without.
  void merge(SoilMemory& other);
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(depth_);
  }

 private:
  std::uint64_t cell(const Vec3& position, std::uint16_t zone) const;

  std::vector<double> widths_;  ///< of cells by zone, m; 0: it does not remember
  std::unordered_map<std::uint64_t, double> depth_;
};

}  // namespace clast::dem_detail

#pragma once
/// Residual indentations of the ground from earlier contacts.
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/types.hpp"
#include "dem/contact/ground_parameters.hpp"

namespace clast::dem_detail {

/// Indentation depths in square plan cells of ground zones with memory (docs/theory.md, Soil
/// memory). A cell stores the maximum, so that the order of contacts does not matter.
class SoilMemory {
 public:
  /// Makes an empty memory.
  /// @param zones  ground zones; `soil_memory` is the cell width of each
  explicit SoilMemory(std::span<const GroundParameters> zones);

  /// True if any zone has a memory.
  bool is_enabled() const;
  bool empty() const { return depth_.empty(); }

  /// Returns the stored indentation along the surface normal, m; 0 if nothing is stored.
  double residual_indentation(const Vec3& position, std::uint16_t zone) const;
  void add_indentation(const Vec3& position, std::uint16_t zone, double residual_indentation);
  /// Moves all indentations of another memory into this one.
  void merge(SoilMemory& other);
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(depth_);
  }

 private:
  std::uint64_t cell(const Vec3& position, std::uint16_t zone) const;

  std::vector<double> widths_;  ///< cell width of each zone, m; 0: no memory
  std::unordered_map<std::uint64_t, double> depth_;
};

}  // namespace clast::dem_detail

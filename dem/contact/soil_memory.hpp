#pragma once
/// Residual indentations of the ground from earlier contacts.
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/types.hpp"
#include "dem/contact/ground_parameters.hpp"

namespace clast::dem_detail {

/// Residual indentations of the ground in a grid of square plan cells (docs/theory.md, Soil
/// memory). A cell stores the largest depth, so that the order of contacts does not matter.
class SoilMemory {
 public:
  /// Makes a grid without indentations.
  /// @param zones  ground zones; the parameter `soil_memory` of a zone is its cell width
  explicit SoilMemory(std::span<const GroundParameters> zones);

  /// True if indentations are stored in at least one zone.
  bool is_enabled() const;
  bool empty() const { return depth_.empty(); }

  /// Returns the depth of the indentation stored at a position, along the surface normal, m; 0 if
  /// nothing is stored.
  double residual_indentation(const Vec3& position, std::uint16_t zone) const;
  void add_indentation(const Vec3& position, std::uint16_t zone, double residual_indentation);
  /// Moves all indentations of another object into this one.
  void merge(SoilMemory& other);
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(depth_);
  }

 private:
  std::uint64_t cell(const Vec3& position, std::uint16_t zone) const;

  std::vector<double> widths_;  ///< cell width of each zone, m; if 0, no indentations are stored
  std::unordered_map<std::uint64_t, double> depth_;
};

}  // namespace clast::dem_detail

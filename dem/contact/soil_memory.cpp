#include "dem/contact/soil_memory.hpp"

#include <algorithm>
#include <cmath>

namespace clast::dem_detail {

SoilMemory::SoilMemory(std::span<const GroundParameters> zones) {
  for (const GroundParameters& zone : zones) widths_.push_back(zone.soil_memory);
}

bool SoilMemory::is_enabled() const {
  return std::any_of(widths_.begin(), widths_.end(), [](double width) { return width > 0.0; });
}

std::uint64_t SoilMemory::cell(const Vec3& position, std::uint16_t zone) const {
  // 24 bits each for x and y: 160 km of cells of a centimetre about the local origin.
  constexpr double kHalf = 8388608.0;
  constexpr std::uint64_t kBits = 24;
  const auto cell_index = [&](double coordinate) {
    const double at = std::floor(coordinate / widths_[zone]) + kHalf;
    return static_cast<std::uint64_t>(std::clamp(at, 0.0, 2.0 * kHalf - 1.0));
  };
  return (std::uint64_t{zone} << 2 * kBits) | (cell_index(position.x()) << kBits) |
         cell_index(position.y());
}

double SoilMemory::residual_indentation(const Vec3& position, std::uint16_t zone) const {
  if (!(widths_[zone] > 0.0)) return 0.0;
  const auto found = depth_.find(cell(position, zone));
  return found == depth_.end() ? 0.0 : found->second;
}

void SoilMemory::add_indentation(const Vec3& position, std::uint16_t zone,
                                 double residual_indentation) {
  if (!(widths_[zone] > 0.0) || !(residual_indentation > 0.0)) return;
  double& depth = depth_[cell(position, zone)];
  depth = std::max(depth, residual_indentation);
}

void SoilMemory::merge(SoilMemory& other) {
  for (const auto& [cell, residual_indentation] : other.depth_) {
    double& depth = depth_[cell];
    depth = std::max(depth, residual_indentation);
  }
  other.depth_.clear();
}

}  // namespace clast::dem_detail

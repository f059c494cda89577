#pragma once
/// Observed surface with what comparisons of surfaces need.
#include <cstdint>
#include <utility>
#include <vector>

#include "reconstruct/registration/detail/nearest_grid.hpp"
#include "reconstruct/registration/oriented_surface.hpp"
#include "reconstruct/registration/similarity.hpp"

namespace clast::reconstruct_detail {

/// Number of points with which surfaces are compared.
enum class PointDensity { kFew, kSparse, kAll };

/// An observed surface, a grid for nearest points, and even subsets of its points.
struct SampledSurface {
  OrientedSurface surface;
  NearestGrid grid;
  std::vector<std::uint32_t> few, sparse;  ///< even subsets of about 80 and 300 points
  std::vector<std::uint32_t> all;          ///< all points, 0, 1, ...
  double diagonal = 0.0;                   ///< of the bounding box, m

  explicit SampledSurface(OrientedSurface observed);
  const std::vector<std::uint32_t>& points_at(PointDensity density) const {
    return density == PointDensity::kFew ? few : density == PointDensity::kSparse ? sparse : all;
  }

  SampledSurface(const SampledSurface&) = delete;
  SampledSurface& operator=(const SampledSurface&) = delete;
};

}  // namespace clast::reconstruct_detail

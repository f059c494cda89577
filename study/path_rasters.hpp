#pragma once
/// Where runs pass, cell by cell of a map.
#include <cstdint>
#include <string>
#include <vector>

#include "study/comparison.hpp"

namespace clast {

/// A value for every cell of a map.
struct RasterLayer {
  std::string name;          ///< "E_95"
  std::string meaning;       ///< with its unit
  std::vector<float> value;  ///< row by row from the top (largest y); NaN: no run came by
};

struct PathRasters {
  Vec2 corner = Vec2::Zero();  ///< lowest x and y of the map, m, a multiple of `cell`
  double cell = 1.0;           ///< m
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<RasterLayer> layers;
};

/// Reach probability, passages, energy (mean, p95, max), passing height (p95) and velocity (max).
/// Each run counts once in every cell that the path of its centre crosses, with its largest value
/// there, read from its stored trajectory; without trajectories there are no cells. A cell is about
/// a four-hundredth of the longer side, a round number of metres, and at least 0.5 m.
PathRasters path_rasters(const Comparison& comparison);

}  // namespace clast

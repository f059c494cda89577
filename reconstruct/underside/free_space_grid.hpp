#pragma once
/// Grid of free space. Its free cells are crossed by lines of sight and contain no rock.
#include <array>
#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Grid of cubes in the frame and units of a point cloud. x varies fastest, then y, then z.
struct FreeSpaceGrid {
  Vec3 origin = Vec3::Zero();                   ///< minimum corner of the grid
  double side = 0.0;                            ///< side of a cube; 0 if nothing is known
  std::array<std::size_t, 3> counts{};          ///< number of cubes along x, y and z
  std::vector<std::uint8_t> is_free_cell = {};  ///< 1: free; 0: rock or unknown

  /// True if the cube that contains a position is free; false outside the grid.
  bool is_free(const Vec3& position) const;
  Vec3 cell_centre(std::size_t cube) const;
};

}  // namespace clast

#pragma once
/// Places that somebody looked through: no rock is there.
#include <array>
#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Cubes in rows along x, then y, then z. In the frame and units of the points it came with.
struct FreeSpaceGrid {
  Vec3 origin = Vec3::Zero();                   ///< the lowest of all cubes
  double side = 0.0;                            ///< of a cube; 0: nothing is known
  std::array<std::size_t, 3> counts{};          ///< cubes along x, y, z
  std::vector<std::uint8_t> is_free_cell = {};  ///< 1: certainly no rock; 0: rock or unknown

  /// Whether the cube that holds a place is empty. Outside of all of them nothing is known.
  bool is_free(const Vec3& position) const;
  /// The middle of a cube by its number.
  Vec3 cell_centre(std::size_t cube) const;
};

}  // namespace clast

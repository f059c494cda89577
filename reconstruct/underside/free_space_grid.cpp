#include "reconstruct/underside/free_space_grid.hpp"

#include <cmath>

namespace clast {

bool FreeSpaceGrid::is_free(const Vec3& position) const {
  if (!(side > 0.0)) return false;
  const Vec3 step = (position - origin) / side;
  std::size_t cube = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const std::size_t count = counts[static_cast<std::size_t>(axis)];
    if (!(step[axis] >= 0.0 && step[axis] < static_cast<double>(count))) return false;
    cube = cube * count + static_cast<std::size_t>(step[axis]);
  }
  return is_free_cell[cube] != 0;
}

Vec3 FreeSpaceGrid::cell_centre(std::size_t cube) const {
  const std::size_t row = cube / counts[0];
  const Vec3 steps(static_cast<double>(cube % counts[0]), static_cast<double>(row % counts[1]),
                   static_cast<double>(row / counts[1]));
  return origin + side * (steps + Vec3::Constant(0.5));
}

}  // namespace clast

#include "terrain/terrain.hpp"

namespace clast {

TerrainSurface make_terrain_surface(const Terrain& terrain, double radius) {
  return {terrain.surface, terrain.zone, radius};
}

}  // namespace clast

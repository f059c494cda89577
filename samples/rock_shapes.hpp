#pragma once
/// Synthetic rock blocks with facets, worn edges and a rough surface. They are star-shaped about an
/// inner point, therefore closed and without self-intersections.
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

struct RockRecipe {
  std::string name = {};
  Vec3 lengths = Vec3::Ones();  ///< about L, I, S, m
  int joint_faces = 0;  ///< 6: bounded by three joint sets first, like a sawn cuboid; else 0
  int facets = 24;      ///< further random planes that cut pieces off
  /// Size of an ellipsoid that bounds the block, relative to its lengths, as few facets may leave a
  /// spike; 0: none.
  double bound = 0.0;
  double sharpness = 18.0;     ///< exponent that blends the planes; larger is sharper
  double notch = 0.0;          ///< depth of a notch in one side, share of the radius
  double roughness = 0.012;    ///< largest octave of the surface relief, share of the mean length
  int octaves = 4;             ///< of the relief, each with half the wavelength and height
  double scan_noise = 0.0008;  ///< standard deviation of the scanner along the ray, m
  int frequency = 10;          ///< 20 frequency^2 triangles
  std::uint64_t seed = 1;
};

/// Makes the scan of a block about the origin, its lengths along x, y and z. Without noise, its
/// shape hardly depends on `frequency`.
TriangleMesh centred_rock(const RockRecipe& recipe);

/// Makes the scan of a block in an arbitrary pose above the origin.
TriangleMesh rock(const RockRecipe& recipe);

/// Returns the recipes of the blocks in samples/blocks.
const std::vector<RockRecipe>& sample_recipes();

/// Returns the recipe of block B01 with 2,562 vertices.
RockRecipe make_fine_recipe();

}  // namespace clast

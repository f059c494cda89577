#pragma once
/// Blocks of a virtual deposit: shapes, sizes, detailed surfaces and simple cores.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "dem/motion/rigid_body.hpp"
#include "mesh/triangle_mesh.hpp"
#include "samples/deposit/deposit_recipe.hpp"

namespace clast {

/// One block in its body frame: the origin is the centre of mass of the core.
struct VirtualBlock {
  std::string shape;         ///< kind of shape: "compact", "platy", ..., or the name of a scan
  TriangleMesh surface;      ///< closed surface that the scanner sees, m; rough down to the spacing
  RigidBody core;            ///< simplified body that comes to rest in its place
  double size = 0.0;         ///< drawn intermediate axis, near that of `surface`, m
  Vec3 axes = Vec3::Zero();  ///< L, I, S of the smallest box of `surface`, m
  double volume = 0.0;       ///< m^3
};

/// Density of the cores, kg/m^3.
inline constexpr double kRockDensity = 2650.0;

/// Closed mesh of a real stone, and its name.
struct StoneScan {
  std::string name;
  TriangleMesh mesh;
};

/// Reads all closed meshes with a single component of a folder, in the order of their names.
/// @throws InputError  if the folder has none
std::vector<StoneScan> read_stone_scans(const std::string& folder);

/// Draws `count` intermediate axes from a power law, N(larger than I) ~ 1/I^2, in random order.
/// They are stratified, so that the largest of n is near `size_ratio` times the smallest.
/// @return m
std::vector<double> draw_block_sizes(std::size_t count, double size_ratio, Random& random);

/// Makes `count` blocks for a deposit.
/// @param scans  stones from which every second block is made; may be empty
std::vector<VirtualBlock> make_deposit_blocks(const DepositRecipe& recipe, std::size_t count,
                                              std::span<const StoneScan> scans, unsigned threads);

}  // namespace clast

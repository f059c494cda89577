#pragma once
/// Making of blocks from closed meshes.
#include <optional>
#include <string>

#include "core/fields.hpp"
#include "library/block.hpp"
#include "shapes/scan_surface.hpp"

namespace clast {

struct BlockOptions {
  bool core = false;             ///< the mesh is the core, unchanged; needs `radius`
  std::optional<double> radius;  ///< Minkowski radius, m
  double radius_share = 0.02;    ///< radius over S if `radius` is not given
  bool convex = false;           ///< the scan is its own hull, and the core stays convex
  double density = 2650.0;       ///< kg/m^3
  bool density_given = false;
  std::optional<double>
      mass;  ///< kg; determines the density, or checks the volume if a density is given
  double accuracy = 1e-4;  ///< relative accuracy of volume and inertia
  double tolerance =
      0.01;  ///< Hausdorff distance to the scan over L, beyond which a warning is added
  /// State a possible radius if the given one is refused, whose search takes as long as twenty
  /// blocks.
  bool suggest_radius = true;

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const BlockOptions& options, Visit&& visit) {
  const auto& [core, radius, radius_share, convex, density, density_given, mass, accuracy,
               tolerance, suggest_radius] = options;
  visit("core", core);
  visit("radius", radius);
  visit("radius_share", radius_share);
  visit("convex", convex);
  visit("density", density);
  visit("density_given", density_given);
  visit("mass", mass);
  visit("accuracy", accuracy);
  visit("tolerance", tolerance);
  visit("suggest_radius", ExcludedField{suggest_radius});
}

/// Maximum relative difference between the principal moments of a block and its scan.
constexpr double kMomentsTolerance = 5e-3;

/// True if the block's deviation and moments are within tolerance; always true for a core.
bool is_within_tolerance(const Block& block, const BlockOptions& options);

/// Makes a block. A core is used unchanged, with coplanar faces merged. Otherwise the core is
/// `surface` offset inwards by the radius, fitted to `scan` until the block is within tolerance or
/// stops improving, and scaled about its centre to the scan's volume.
/// @param surface  closed, outward, simplified; outer surface of the rock, or its core
/// @param scan  full-resolution closed scan from which `surface` was simplified; reference of
///              deviation and volume
/// @param source  file, digest and options of the previous steps; `options` are appended
/// @throws GeometryError, InputError  with the block's id in the message
Block make_block(const std::string& id, const TriangleMesh& surface, const ScanSurface& scan,
                 BlockSource source, const BlockOptions& options);

/// Makes a block from a given core and radius, which override `options`. The surface of a ball or
/// capsule is its rounded surface.
/// @throws GeometryError, InputError  with the block's id in the message
Block make_block(const std::string& id, const SpheroPolyhedron& body, BlockSource source,
                 BlockOptions options);

}  // namespace clast

#pragma once
/// Construction of blocks from closed meshes.
#include <optional>
#include <string>

#include "core/fields.hpp"
#include "library/block.hpp"
#include "shapes/scan_surface.hpp"

namespace clast {

struct BlockOptions {
  bool core = false;  ///< true: the mesh is the core and is not changed; requires `radius`
  std::optional<double> radius;   ///< Minkowski radius, m
  double radius_fraction = 0.02;  ///< ratio of radius to S, if `radius` is not given
  bool convex = false;            ///< true: the scan is convex, and the core stays convex
  double density = 2650.0;        ///< kg/m^3
  bool density_given = false;
  std::optional<double>
      mass;  ///< mass, kg; it determines the density, or checks the volume if a density is given
  double accuracy = 1e-4;   ///< relative accuracy of volume and inertia
  double tolerance = 0.01;  ///< maximum Hausdorff distance to the scan relative to L; a warning is
                            ///< added if it is exceeded
  /// If true, errors for an impossible radius state a possible one. The search costs twenty blocks.
  bool suggest_radius = true;
  /// If true, the largest distances are only compared with the tolerance. The deviation of the
  /// block is then a bound within the tolerance, or a distance beyond it.
  bool quick_deviation = false;
  unsigned threads = 1;  ///< number of threads, 0: one per core; does not affect the block

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const BlockOptions& options, Visit&& visit) {
  const auto& [core, radius, radius_fraction, convex, density, density_given, mass, accuracy,
               tolerance, suggest_radius, quick_deviation, threads] = options;
  visit("core", core);
  visit("radius", radius);
  visit("radius_share", radius_fraction);
  visit("convex", convex);
  visit("density", density);
  visit("density_given", density_given);
  visit("mass", mass);
  visit("accuracy", accuracy);
  visit("tolerance", tolerance);
  visit("suggest_radius", ExcludedField{suggest_radius});
  visit("quick_deviation", ExcludedField{quick_deviation});
  visit("threads", ExcludedField{threads});
}

/// Maximum relative difference between the principal moments of a block and its scan.
constexpr double kMomentsTolerance = 5e-3;

/// True if the deviation and moments of the block are within tolerance. Always true for a core.
bool is_within_tolerance(const Block& block, const BlockOptions& options);

/// Makes a block from a closed mesh. If `options.core`, the mesh is the core, whose coplanar faces
/// are merged. Otherwise, the core is the mesh offset inwards by the radius. It is fitted to `scan`
/// until the block is within tolerance or no longer improves, and scaled to the volume of the scan.
/// @param surface  simplified mesh, closed, outward; outer surface of the rock, or its core
/// @param scan  closed scan at full resolution, from which `surface` was simplified; reference of
///              deviation and volume
/// @param source  file, digest and options of the previous steps, to which `options` are appended
/// @throws GeometryError, InputError  if the block cannot be made; names its id
Block make_block(const std::string& id, const TriangleMesh& surface, const ScanSurface& scan,
                 BlockSource source, const BlockOptions& options);

/// Makes a block from a core and radius, which override those of `options`. The stored surface of a
/// ball or capsule is its rounded surface.
/// @throws GeometryError, InputError  if the block cannot be made; names its id
Block make_block(const std::string& id, const SpheroPolyhedron& body, BlockSource source,
                 BlockOptions options);

}  // namespace clast

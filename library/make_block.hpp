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
  unsigned threads = 1;  ///< number of threads, 0: one per core; does not affect the block

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const BlockOptions& options, Visit&& visit) {
  const auto& [core, radius, radius_fraction, convex, density, density_given, mass, accuracy,
               tolerance, suggest_radius, threads] = options;
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
  visit("threads", ExcludedField{threads});
}

/// Body fitted to a scan, and its deviation as far as a search for the best body needs it.
struct FittedBody {
  TriangleMesh surface;  ///< mesh that the core was made from
  SpheroPolyhedron body;
  double distance = 0.0;  ///< largest distance from the scan, m: an upper bound within the
                          ///< tolerance, or a distance beyond it
  /// Largest of two ratios: distance over tolerance, and relative difference of a principal moment
  /// over 0.5 %. The body is within tolerance if it is at most 1.
  double deviation_ratio = 0.0;

  bool is_within_tolerance() const { return deviation_ratio <= 1.0; }
};

/// Fits a body to a scan. Its core is first the mesh offset inwards by the radius. It is moved
/// until the body is within tolerance or no longer improves, and scaled to about the volume of the
/// scan.
/// @param surface  simplified mesh, closed, outward
/// @param scan  closed scan at full resolution, from which `surface` was simplified
/// @param options  not with `core`
/// @throws GeometryError, InputError  if the body cannot be made
FittedBody fit_body(const TriangleMesh& surface, const ScanSurface& scan,
                    const BlockOptions& options);

/// Makes a block from a fitted body, which is scaled to the volume of the scan.
/// @param options  those of the fit
/// @throws GeometryError, InputError  if the block cannot be made; names its id
Block make_block(const std::string& id, const FittedBody& fitted, const ScanSurface& scan,
                 BlockSource source, const BlockOptions& options);

/// Makes a block from a closed mesh. If `options.core`, the mesh is the core, whose coplanar faces
/// are merged. Otherwise, the core is fitted to `scan` by `fit_body`.
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

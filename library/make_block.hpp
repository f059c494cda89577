#pragma once
/// From a closed mesh to a block with everything computed.
#include <optional>
#include <string>

#include "core/fields.hpp"
#include "library/block.hpp"
#include "shapes/scan_surface.hpp"

namespace clast {

/// How a mesh becomes a block.
struct BlockOptions {
  bool core = false;             ///< the mesh is the core, unchanged; needs `radius`
  std::optional<double> radius;  ///< Minkowski radius, m
  double radius_share = 0.02;    ///< of S, where `radius` is not given
  bool convex = false;           ///< the scan is its own hull, and the core is kept convex
  double density = 2650.0;       ///< kg/m^3
  bool density_given = false;
  std::optional<double> mass;  ///< kg: sets the density, or checks the volume if that is given
  double accuracy = 1e-4;      ///< relative, of volume and inertia
  double tolerance = 0.01;     ///< Hausdorff distance to the scan, of L; beyond it is a warning
  /// Whether the refusal of a radius says which one works; to find that takes as long as twenty
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

/// Largest relative difference between the principal moments of a block and its scan.
constexpr double kMomentsTolerance = 5e-3;

/// Is the block as near to its scan as asked, and are its moments? Always true of a core.
bool is_within_tolerance(const Block& block, const BlockOptions& options);

/// A core is taken as it is, faces in one plane merged to polygons. Else the core is `surface`
/// moved in by the radius, fitted to `scan` until the block is within the tolerance or gets no
/// nearer, then scaled about its own centre by the little that gives the rounded body the volume of
/// `scan`.
///
/// @param surface  closed, outward, simplified; the outer surface of the rock, or its core
/// @param scan     the full-resolution closed scan `surface` was simplified from: the deviation and
///                 the volume are judged against it
/// @param source   file, hash, and the options of the steps before; what `options` says is added
/// @throws GeometryError, InputError  with the block's id in the message
Block make_block(const std::string& id, const TriangleMesh& surface, const ScanSurface& scan,
                 BlockSource source, const BlockOptions& options);

/// A block that is given whole, core and radius; `options` say nothing of these. A ball's or a
/// capsule's surface is its skin.
/// @throws GeometryError, InputError  with the block's id in the message
Block make_block(const std::string& id, const SpheroPolyhedron& body, BlockSource source,
                 BlockOptions options);

}  // namespace clast

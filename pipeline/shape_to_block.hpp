#pragma once
/// Construction of blocks from .shp shapes.
#include "pipeline/scan_to_block.hpp"
#include "shapes/shp_file.hpp"

namespace clast {

/// Makes a block with the core and radius of a .shp shape, in the frame of the file. Orients and
/// repairs faces as in a scan, merges coplanar ones, and computes mass and inertia. If volume or
/// I/m of the file differ by more than their sampling error, a warning states both values.
/// @param options  units, up axis, density, mass and accuracy are used
/// @throws InputError  if `options` has another radius, the shape is a surface (isSurface), or its
///                     size is implausible
/// @throws GeometryError  if the shape is not a closed polyhedron, ball or capsule
Block make_shape_block(const ShpShape& shape, const std::filesystem::path& path,
                       const std::string& id, const ScanToBlockOptions& options = {},
                       const ScanCallbacks& callbacks = {});

}  // namespace clast

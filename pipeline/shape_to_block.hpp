#pragma once
/// Making of blocks from .shp shapes.
#include "pipeline/scan_to_block.hpp"
#include "shapes/shp_file.hpp"

namespace clast {

/// Makes a block from a shape, with its core and radius; of `options`, units, up axis, density,
/// mass and accuracy are used. Faces are oriented and repaired like a scan, and coplanar faces
/// merged. The block's frame is that of the file. Mass and inertia are computed anew; a warning
/// states both values if volume or I/m of the file differ by more than their sampling error.
/// @throws InputError  if `options` give another radius, the shape is a surface (isSurface), or its
///                     size is implausible
/// @throws GeometryError  if it is not a closed polyhedron, ball or capsule
Block make_shape_block(const ShpShape& shape, const std::filesystem::path& path,
                       const std::string& id, const ScanToBlockOptions& options = {},
                       const ScanCallbacks& callbacks = {});

}  // namespace clast

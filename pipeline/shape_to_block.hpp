#pragma once
/// From a shape of a .shp file to a block.
#include "pipeline/scan_to_block.hpp"
#include "shapes/shp_file.hpp"

namespace clast {

/// The shape is the core and the file's radius its radius; of `options` units, up-axis, density,
/// mass and accuracy are used. Faces are turned outwards and repaired as a scan's are, and those in
/// one plane become one polygon. The block's frame is that of the vertices in the file. Mass and
/// inertia are computed anew; where the file's volume or I/m differs by more than its sampling
/// explains, a warning gives both.
/// @throws InputError     `options` give another radius; the shape is a surface (isSurface); a size
///                        that no block has
/// @throws GeometryError  not a closed polyhedron, a ball or a capsule
Block make_shape_block(const ShpShape& shape, const std::filesystem::path& path,
                       const std::string& id, const ScanToBlockOptions& options = {},
                       const ScanCallbacks& callbacks = {});

}  // namespace clast

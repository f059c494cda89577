#pragma once
/// Holes in a mesh.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Triangulates the holes whose bounds are at most `widest` in every direction, and reports those
/// that are wider. A hole is a loop of border sides that runs the other way round than the outer
/// border of a component does: clockwise, seen against the normals of the triangles along it; or an
/// upright or narrow loop in a component that has a larger one, its border. New triangles have the
/// source of a triangle beside them.
/// @param surface  triangles of a component agree in orientation
/// @param slit     mean width of what counts as narrow, m
void fill_surface_holes(RawSurface& surface, double widest, double slit, TerrainReport& report);

}  // namespace clast::terrain_detail

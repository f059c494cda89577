#pragma once
/// Ground that lies double.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// On a vertical through sound ground, faces that face up and faces that face down alternate: two
/// that face up over each other are two surfaces of the same place. Looked for over the centroid of
/// every triangle. A small component that lies so over (or under) other ground with nine tenths of
/// its plan area is dropped; folds of less than a thousandth of the plan area are noted.
/// @param surface  oriented
/// @param width    an overhang with no more room under it than this lies double too, m
/// @throws GeometryError  any other double ground: its area and a place
void remove_overlapping_ground(RawSurface& surface, double width, TerrainReport& report);

}  // namespace clast::terrain_detail

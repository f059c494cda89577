#pragma once
/// Why a surface bounds no block: what is checked of one that is repaired, and how it is refused.
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/detail/repair_log.hpp"

namespace clast::reconstruct_detail {

/// What a person can do about a surface that is refused.
inline constexpr const char* kRepairAdvice =
    "; close and clean the scan first, for example in MeshLab (Filters > Remeshing > Close Holes, "
    "or Screened Poisson) or CloudCompare (PoissonRecon)";

/// @throws GeometryError  a vertex is not finite, or farther from the origin than
///                        `kMaxCoordinate`
void check_coordinates(const TriangleMesh& mesh);
/// @throws GeometryError  less than 1 nm across, as what a damaged file leaves beside vertices of
///                        no triangle
void check_extent(const TriangleMesh& mesh);

/// @throws GeometryError  no triangle is left
void check_not_empty(const TriangleMesh& mesh);

/// @throws GeometryError  inside and outside can't be distinguished
void check_orientable(const TriangleMesh& mesh, const OrientationResult& facing, const RepairLog& log);

/// @param welded  the surface before any repair: messages count what the file has
/// @throws GeometryError  one hole has more than `largest` of the repaired surface
void check_hole(const FilledHole& hole, double largest, const TriangleMesh& welded,
                const RepairLog& log);

/// @param welded  as above
/// @throws GeometryError  the surface is not closed
void check_closed(const TriangleMesh& mesh, const TriangleMesh& welded, const RepairLog& log);

/// @throws GeometryError  the surface encloses nothing
void check_volume(const TriangleMesh& closed);

}  // namespace clast::reconstruct_detail

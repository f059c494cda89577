#pragma once
/// Checks that a repaired surface bounds a block, with explanatory errors.
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/detail/repair_log.hpp"

namespace clast::reconstruct_detail {

/// Advice that ends error messages about unrepairable surfaces.
inline constexpr const char* kRepairAdvice =
    "; close and clean the scan first, for example in MeshLab (Filters > Remeshing > Close Holes, "
    "or Screened Poisson) or CloudCompare (PoissonRecon)";

/// Checks the coordinates of a mesh.
/// @throws GeometryError  if a vertex is not finite, or farther from the origin than
///                        `kMaxCoordinate`
void check_coordinates(const TriangleMesh& mesh);
/// Checks the extent of a mesh.
/// @throws GeometryError  if the extent is below 1 nm, as in damaged files
void check_extent(const TriangleMesh& mesh);

/// Checks that a mesh has triangles.
/// @throws GeometryError  if the mesh has no triangle
void check_not_empty(const TriangleMesh& mesh);

/// Checks that a surface is orientable.
/// @throws GeometryError  if it is not
void check_orientable(const TriangleMesh& mesh, const OrientationResult& facing,
                      const RepairLog& log);

/// Checks the size of a filled hole.
/// @param welded  surface after welding, before other repairs; for counts in messages
/// @throws GeometryError  if the filling exceeds the fraction `largest` of the repaired surface
void check_hole_size(const FilledHole& hole, double largest, const TriangleMesh& welded,
                     const RepairLog& log);

/// Checks that a surface is closed.
/// @param welded  see `check_hole_size`
/// @throws GeometryError  if it is not closed
void check_closed(const TriangleMesh& mesh, const TriangleMesh& welded, const RepairLog& log);

/// Checks the volume enclosed by a surface.
/// @throws GeometryError  if the surface encloses no volume
void check_volume(const TriangleMesh& closed);

}  // namespace clast::reconstruct_detail

#pragma once
/// Report of defects and repairs.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_topology.hpp"

namespace clast {

/// Kinds of defects and their treatment, in the order of the repair.
enum class DefectKind {
  kNearVertices,             ///< nearly coincident vertices: merged
  kDegenerate,               ///< degenerate or duplicate triangles: removed
  kFoldedPair,               ///< back-to-back triangles: removed
  kFin,                      ///< protruding or overlying fragments: removed
  kNonManifoldEdge,          ///< non-manifold edges: split
  kInconsistentOrientation,  ///< triangles with opposite orientation: flipped
  kNonManifoldVertex,        ///< vertices with several fans: split
  kDuplicateSheet,           ///< open components on the block, or copies of a part of it: removed
  kDuplicateShell,           ///< closed copies of the whole block: removed
  kIsland,                   ///< small components beside the block, loose ones inside it: removed
  kInnerShell,               ///< closed components inside the block: removed, or kept as cavities
  kSpike,                    ///< protruding vertices: flattened
  kHole,                     ///< holes: filled
  kSelfIntersection,         ///< intersecting triangles: replaced
  kInwardOrientation,        ///< inward surface: flipped
  kTunnel                    ///< tunnels through the block: reported only
};

/// Defects of one kind. Lengths are in metres. Positions are converted by
/// `RepairOptions::to_reported_position`.
struct Defect {
  DefectKind kind;
  std::size_t count = 0;       ///< number of vertices, edges, triangles, components or holes
  double area_fraction = 0.0;  ///< area of the defects as a fraction of the retained surface
  double size = 0.0;  ///< distance, height or length of the largest defect, m; 0 if undefined
  std::optional<Vec3> position;  ///< position of the largest or first defect
};

struct FilledHole {
  std::size_t border_edges = 0;
  double perimeter = 0.0;      ///< m
  double radius = 0.0;         ///< largest distance of the border from its centre, m
  double area = 0.0;           ///< area of the filling, m^2
  double area_fraction = 0.0;  ///< area of the filling as a fraction of the repaired surface
  Vec3 centre = Vec3::Zero();
  bool is_fan = false;  ///< true if the filling has no vertices besides those of the border
  /// Possible decrease and increase of the volume if the hole were filled differently, m^3.
  double volume_below = 0.0, volume_above = 0.0;
};

/// Reason why one of two copies of a surface was kept.
enum class RetentionReason {
  kLarger,        ///< it is larger; neither is more complete or finer
  kFiner,         ///< it has more triangles
  kMoreComplete,  ///< the other copy covers only a part of the block
  kClosed,        ///< the other copy is open
};

/// Removed copy of (part of) the surface, of a block scanned or stored twice.
struct DuplicateSurface {
  bool closed = false;         ///< true if the copy is closed
  double area_fraction = 0.0;  ///< area as a fraction of the area of the retained surface
  double offset = 0.0;         ///< mean distance from the retained surface, positive outside, m
  double distance = 0.0;       ///< root mean square distance, m
  double scale = 1.0;          ///< size relative to the retained surface, from the best fit
  double volume_change = 0.0;  ///< change of the block's volume if this copy were kept instead, m^3
  double retained_volume =
      0.0;  ///< volume of the block with the retained copy, m^3; 0 if that is open
  RetentionReason retention_reason = RetentionReason::kLarger;
};

/// Area fraction of the repaired surface above which a hole is reported separately.
constexpr double kLargeHoleFraction = 0.1;

struct RepairReport {
  MeshReport as_read;                        ///< surface after welding, before other repairs
  std::vector<Defect> defects;               ///< empty if the surface was sound
  std::vector<FilledHole> holes;             ///< largest area first
  std::vector<DuplicateSurface> duplicates;  ///< copies with at least 5 % of the block's area
  double filled_fraction = 0.0;  ///< area of all fillings as a fraction of the repaired surface
  /// Possible decrease and increase of the volume due to fillings and copies, m^3.
  double volume_below = 0.0, volume_above = 0.0;
  std::size_t inner_shells = 0;     ///< number of closed components inside the block
  double inner_shell_volume = 0.0;  ///< their total volume, m^3
  bool inner_shells_retained = false;
  /// Relative volume change due to the repair of self-intersections.
  double crossing_volume_change = 0.0;
  /// Relative excess volume of a wrap before it was scaled. Set if wrapping was necessary.
  std::optional<double> relative_wrap_excess;

  const Defect* find_defect(DefectKind kind) const;  ///< null if there is none of that kind
};

/// Merges the reports of two successive repairs of a surface. Counts are added, and the larger size
/// is kept. `as_read` is that of the first report, if known.
RepairReport merged(RepairReport first, RepairReport second);

/// Returns the name of a kind in tables, such as "spikes put back".
const char* name_of(DefectKind kind);

/// Describes the repairs in sentences with counts, sizes and positions.
std::vector<std::string> describe_repairs(const RepairReport& report);

}  // namespace clast

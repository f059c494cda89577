#pragma once
/// Report of defects and repairs.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_topology.hpp"

namespace clast {

/// Kinds of defects, in the order of their repair.
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
  kIsland,                   ///< components beside the block or loose inside it: removed
  kInnerShell,               ///< closed components inside the block: removed, or kept as cavities
  kSpike,                    ///< protruding vertices: flattened
  kHole,                     ///< holes: filled
  kSelfIntersection,         ///< intersecting triangles: replaced
  kInwardOrientation,        ///< inward surface: flipped
  kTunnel                    ///< through the block: reported only
};

/// Defects of one kind. Lengths in metres; positions as converted by
/// `RepairOptions::reported_place`.
struct Defect {
  DefectKind kind;
  std::size_t count = 0;         ///< number of vertices, edges, triangles, components or holes
  double area_fraction = 0.0;    ///< of the area of the retained surface
  double size = 0.0;             ///< distance, height or length of the largest, m; 0 if it has none
  std::optional<Vec3> position;  ///< of the largest or the first
};

struct FilledHole {
  std::size_t border_edges = 0;
  double perimeter = 0.0;      ///< m
  double radius = 0.0;         ///< largest distance of the border from its centre, m
  double area = 0.0;           ///< of the filling, m^2
  double area_fraction = 0.0;  ///< of the repaired surface
  Vec3 centre = Vec3::Zero();
  bool is_fan = false;  ///< closed by triangles between border vertices only
  /// Possible decrease and increase of the volume by other fillings, m^3.
  double volume_below = 0.0, volume_above = 0.0;
};

/// Reason why one of two copies was kept.
enum class RetentionReason {
  kSize,    ///< neither is more complete or finer: the larger one
  kFiner,   ///< more triangles
  kWhole,   ///< the other is of a part of the block only
  kClosed,  ///< the other is open
};

/// Removed copy of the block's surface, or of a part of it: unregistered double scans, or a scan
/// stored twice.
struct DuplicateSurface {
  bool closed = false;           ///< bounds a block by itself
  double area_fraction = 0.0;    ///< of the area of the surface that was kept
  double offset = 0.0;           ///< mean distance, positive outside, m
  double distance = 0.0;         ///< root mean square distance, m
  double scale = 1.0;            ///< best-fit size relative to the retained surface
  double volume_change = 0.0;    ///< volume change of the block with this copy, m^3
  double retained_volume = 0.0;  ///< volume with the retained copy, m^3; 0 if it is open
  RetentionReason retention_reason = RetentionReason::kSize;
};

/// Fraction of the repaired surface above which a hole is reported separately, because its filling
/// is a guess.
constexpr double kLargeHole = 0.1;

struct RepairReport {
  MeshReport as_read;                        ///< after welding, before other repairs
  std::vector<Defect> defects;               ///< empty if the surface was sound
  std::vector<FilledHole> holes;             ///< largest area first
  std::vector<DuplicateSurface> duplicates;  ///< copies with at least 5 % of the block's area
  double filled_fraction = 0.0;              ///< of the repaired surface
  /// Possible decrease and increase of the volume due to fillings and copies, m^3.
  double volume_below = 0.0, volume_above = 0.0;
  std::size_t inner_shells = 0;     ///< bubbles, removed unless kept on request
  double inner_shell_volume = 0.0;  ///< total, m^3
  bool inner_shells_retained = false;
  /// Relative volume change of the self-intersection repair; 0 without one.
  double crossing_volume_change = 0.0;
  /// Relative excess volume of a wrap before scaling, if wrapping was necessary.
  std::optional<double> wrap_bias;

  const Defect* find_defect(DefectKind kind) const;  ///< null if there is none of that kind
};

/// Merges the reports of two repairs of the same surface: counts are added, the larger size is
/// kept. The surface as read is that of the first, if known.
RepairReport merged(RepairReport first, RepairReport second);

/// Returns the name of a kind in tables: "spikes put back".
const char* name_of(DefectKind kind);

/// Describes the repairs in sentences with counts, sizes and positions.
std::vector<std::string> describe_repairs(const RepairReport& report);

}  // namespace clast

#pragma once
/// What was wrong with a surface, and what was done about it.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_topology.hpp"

namespace clast {

/// In the order in which they are repaired.
enum class DefectKind {
  kNearVertices,             ///< stored more than once, a little apart: joined
  kDegenerate,               ///< triangles without area, or stored twice: dropped
  kFoldedPair,               ///< triangles back to back with another: dropped
  kFin,                      ///< scraps that stand on the surface, or lie on it rim to rim: dropped
  kNonManifoldEdge,          ///< edges of more than two triangles: cut apart
  kInconsistentOrientation,  ///< triangles that face the other way than their neighbours: turned
  kNonManifoldVertex,        ///< vertices where the surface touches itself: split
  kDuplicateSheet,     ///< open components that lie on the block, or are copies of a part of it:
                       ///< dropped
  kDuplicateShell,     ///< closed copies of the whole block a little apart from it: dropped
  kIsland,             ///< components beside the block, or loose in it: dropped
  kInnerShell,         ///< closed components inside the block: dropped, or kept as cavities
  kSpike,              ///< vertices that stand out of their neighbourhood: put back
  kHole,               ///< filled
  kSelfIntersection,   ///< triangles that pass through others: replaced
  kInwardOrientation,  ///< the whole surface faced inwards: turned
  kTunnel              ///< goes through the block: reported, nothing is done
};

/// All defects of one kind. Lengths in metres; places as `RepairOptions::reported_place` says.
struct Defect {
  DefectKind kind;
  std::size_t count = 0;  ///< vertices, edges, triangles, components or holes: what `kind` names
  double area_fraction = 0.0;    ///< of the surface as read (holes: as repaired) that it covers
  double size = 0.0;             ///< how far apart, high or long the largest is, m; 0: has no size
  std::optional<Vec3> position;  ///< a point of the largest one, or of the first
};

/// A hole that was filled.
struct FilledHole {
  std::size_t border_edges = 0;
  double perimeter = 0.0;      ///< m
  double radius = 0.0;         ///< from the middle of its border to the farthest point of it, m
  double area = 0.0;           ///< of the filling, m^2
  double area_fraction = 0.0;  ///< of the repaired surface
  Vec3 centre = Vec3::Zero();
  bool is_fan = false;  ///< closed by triangles between its border vertices alone
  /// How much smaller or larger the volume may be here than with the filling, m^3.
  double volume_below = 0.0, volume_above = 0.0;
};

/// Why of two copies of a surface one was kept.
enum class RetentionReason {
  kSize,    ///< neither is more complete or finer than the other: the larger, which is heavier
  kFiner,   ///< it has more triangles
  kWhole,   ///< the other is of a part of the block only
  kClosed,  ///< the other is open
};

/// A second copy of the block's surface, or of a part of it, that was dropped: two scans, or a scan
/// stored twice, that were not registered.
struct DuplicateSurface {
  bool closed = false;           ///< it bounds a block by itself
  double area_fraction = 0.0;    ///< of the area of the surface that was kept
  double offset = 0.0;           ///< mean distance from that, positive outside of it, m
  double distance = 0.0;         ///< root mean square distance from it, m
  double scale = 1.0;            ///< its size against it, as they fit best
  double volume_change = 0.0;    ///< additional volume of the block with this one, m^3
  double retained_volume = 0.0;  ///< of the block with the one that was kept; 0: that is open, m^3
  RetentionReason retention_reason = RetentionReason::kSize;
};

/// A hole larger than this share of the repaired surface is reported by itself: its filling is a
/// guess.
constexpr double kLargeHole = 0.1;

struct RepairReport {
  MeshReport as_read;                        ///< after welding, before any other repair
  std::vector<Defect> defects;               ///< none: the surface was sound
  std::vector<FilledHole> holes;             ///< largest area first
  std::vector<DuplicateSurface> duplicates;  ///< copies with 5 % of the block's area and more
  double filled_fraction = 0.0;              ///< fillings over the whole repaired surface
  /// How much less or more than the volume of the repaired surface the block may have, as far as
  /// fillings and doubled surfaces leave that uncertain, m^3.
  double volume_below = 0.0, volume_above = 0.0;
  std::size_t inner_shells = 0;     ///< bubbles inside, dropped unless they were to be kept
  double inner_shell_volume = 0.0;  ///< of all of them, m^3
  bool inner_shells_retained = false;
  /// Relative volume that replacing crossing triangles added; 0 where there were none.
  double crossing_volume_change = 0.0;
  /// Set where only a wrap gave a sound surface: relative volume it had too much before it was
  /// scaled back.
  std::optional<double> wrap_bias;

  const Defect* find_defect(DefectKind kind) const;  ///< null: none of that kind
};

/// One report of two repairs of the same surface: counts of a kind add up, the larger place stays.
/// The surface as read is that of the first, unless nothing is known of it.
RepairReport merged(RepairReport first, RepairReport second);

/// What a kind is called in a table: "spikes put back".
const char* name_of(DefectKind kind);

/// The report as sentences, one for each repair, with counts, sizes and places.
std::vector<std::string> describe_repairs(const RepairReport& report);

}  // namespace clast

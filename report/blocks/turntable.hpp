#pragma once
/// Interactive 3-D view of a block with its scan, or of another shape with its block: both
/// surfaces, the distance between them, and the smallest box.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "library/block.hpp"

namespace clast::report_detail {

/// Limits of the amount of data of a 3-D view.
struct TurntableLimits {
  /// Maximum number of scan triangles; finer scans are simplified.
  std::size_t scan_triangles = 30'000;
  double deviation_cells = 48.0;  ///< number of samples of the deviation along the longest side L

  void check() const;  ///< throws InputError naming the field and its value
};

/// Function that is true for places on the surface of a block which the scan did not observe.
using UnobservedPlaces = std::function<bool(const Vec3& place)>;

/// Contents of a 3-D view. The meshes and the box are in one frame, in m.
struct TurntableContents {
  std::string name;
  std::string unit = "m";
  TriangleMesh shape;  ///< such as the block
  /// Component of each triangle of `shape`, in different colours; empty: one colour.
  std::vector<std::uint16_t> components = {};
  bool smooth = false;   ///< true: `shape` is drawn with shading across its edges
  TriangleMesh surface;  ///< that `shape` replaces, such as the scan; may be empty
  OrientedBox box;       ///< of which the sides are labelled
  /// Signed distance of a point from `surface`, negative inside; empty: not shown.
  std::function<double(const Vec3& point)> distance = {};
  double reach = 0.0;  ///< largest distance, m; used with `distance`
};

/// Names of what a 3-D view shows.
struct TurntableChoices {
  std::string shape = "block", surface = "scan", both = "block in its scan",
              distance = "distance from the scan";
};

/// Formats the data of the 3-D view of a block as JSON for turntable.js. Members:
/// - `name`; `unit` ("m", or "units" for unscaled blocks); `size`; `centre` [3].
/// - `block` and, unless the block was made from a core, `scan`: meshes {vertices int16 [n][3],
///   triangles uint32 [m][3], unobserved uint8 [m], components uint16 [m], smooth}. Vertices are
///   relative to `centre`, in units of `size` / 32767. `unobserved` is 1 for triangles that are
///   drawn in orange; it exists if any is. `components` and `smooth` exist for other shapes only.
/// - `box`: smallest box {centre [3], axes [3][3], lengths [3]}.
/// - `deviation` {reach, colours, pieces uint8 [m], shares int8}, if the block deviates from its
///   scan. `pieces` is the number n of subdivisions per side of each block triangle. `shares` is
///   the distance from the scan in units of `reach` / 127, at the (n + 1)(n + 2) / 2 lattice points
///   of each triangle, row by row from its first vertex.
/// @param unobserved  if empty, all of the surface counts as observed
std::string format_turntable_json(const Block& block, const TurntableLimits& limits = {},
                                  const UnobservedPlaces& unobserved = {});

/// Formats the data of another 3-D view: `shape` as `block`, and `surface` as `scan`.
std::string format_turntable_json(const TurntableContents& contents,
                                  const TurntableLimits& limits = {},
                                  const UnobservedPlaces& unobserved = {});

/// Formats a 3-D view with its controls. The page must contain `turntable_script` once.
/// @param source  id of the page element with the data; empty if a script sets it later
std::string format_turntable_view(const std::string& source, const TurntableChoices& choices = {});

/// Returns the scripts of 3-D views as page elements, or a note on how to install three.js if it is
/// missing.
std::string turntable_script();

/// Formats the section with the 3-D view on the page of a block.
std::string format_turntable_section(const Block& block, const UnobservedPlaces& unobserved = {});

}  // namespace clast::report_detail

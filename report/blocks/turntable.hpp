#pragma once
/// Interactive 3-D view of a block with its scan, deviations and smallest box.
#include <cstddef>
#include <string>

#include "library/block.hpp"

namespace clast::report_detail {

/// Limits of the data in a page.
struct TurntableLimits {
  std::size_t scan_triangles = 30'000;  ///< finer scans are coarsened
  double deviation_cells = 48.0;        ///< samples of the deviation along L

  void check() const;  ///< throws InputError naming the field and its value
};

/// Makes the JSON for turntable.js. Meshes are {vertices int16 [n][3], triangles uint32 [m][3]},
/// with vertices in 1/32767 of `size` about `centre`.
///
/// `name`; `unit` "m", or "units" for unscaled blocks; `size`; `centre` [3]; meshes `block` and
/// `scan` (unless the block was made from a core); `box` {centre [3], axes [3][3], lengths [3]};
/// and, if the block deviates from its scan, `deviation` {reach, colours, pieces uint8 [m], shares
/// int8}: the number n of subdivisions per side of each block triangle, and the distance from the
/// scan over `reach`, in 1/127, at its (n + 1)(n + 2) / 2 lattice points, row by row from the first
/// vertex.
std::string format_turntable_json(const Block& block, const TurntableLimits& limits = {});

/// Formats the view with its controls; the page must contain `turntable_script` once.
/// @param source  id of the packed element with the JSON; empty: none yet
std::string format_turntable_view(const std::string& source);

/// Returns unpack.js, three.js and the viewer, or a note on how to install three.js.
std::string turntable_script();

/// Formats the section "In 3-D" of a block's page.
std::string format_turntable_section(const Block& block);

}  // namespace clast::report_detail

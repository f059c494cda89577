#pragma once
/// A block that a reader turns: its scan, the block, how far they are apart, and the sides of its
/// box.
#include <cstddef>
#include <string>

#include "library/block.hpp"

namespace clast::report_detail {

/// Limits that keep a page small.
struct TurntableLimits {
  std::size_t scan_triangles = 30'000;  ///< a finer scan is joined to larger triangles
  double deviation_cells = 48.0;        ///< along L: how finely distances are sampled

  void check() const;  ///< throws InputError naming the field and its value
};

/// JSON for turntable.js. Meshes are {vertices int16 [n][3], triangles uint32 [m][3]}, vertices in
/// 1/32767 of `size` about `centre`.
///
/// `name`; `unit` "m", or "units" of an unscaled block; `size`; `centre` [3]; `block` and, unless
/// the block was made from a core, `scan`, which are meshes; `box` {centre [3], axes [3][3],
/// lengths [3]}, each axis with its coordinates; where the block is off its scan, `deviation`
/// {reach, colours, pieces uint8 [m], shares int8}: for each triangle of the block the number n of
/// pieces of a side, and the distance from the scan over `reach`, in 1/127, at the
/// (n + 1)(n + 2) / 2 corners between them, row by row from the first corner.
std::string turntable_json(const Block& block, const TurntableLimits& limits = {});

/// The view with its controls; `turntable_script` must follow once.
/// @param source  id of the packed element with the JSON; empty: none yet
std::string format_turntable_view(const std::string& source);

/// unpack.js, three.js and what draws turntables. Without three.js a sentence that says so and what
/// to do.
std::string turntable_script();

/// Section "In 3-D" of a page about one block.
std::string format_turntable_section(const Block& block);

}  // namespace clast::report_detail

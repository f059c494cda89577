#pragma once
/// How large and how small a body with unseen parts may be.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "reconstruct/detail/box_ranges.hpp"
#include "reconstruct/underside.hpp"
#include "shapes/triangle_mesh.hpp"

namespace clast::detail {

/// Bounds of a body whose seen flanks continue as they are, m^3 and m.
struct UnseenBounds {
  double lower_volume = 0.0;           ///< with a film that is dented as the seen surface is
  std::optional<double> upper_volume;  ///< none: too large a part is unseen
  std::optional<SideBounds> sides;     ///< none without an upper volume
};

/// What is known of a body beside its seen surface.
struct UnseenParts {
  std::size_t first = 0;                ///< triangles from this one on are films across the holes
  std::span<const std::uint32_t> rims;  ///< vertices around the holes
  std::optional<Plane> floor;           ///< the body lies above it; normal up
};

/// The upper volume is that of the seen part with all that lies behind its films, as seen from its
/// middle, and within the planes of its flanks (`flank_planes`) and above the floor. See
/// docs/theory.md.
/// @param closed  outward, with the films
UnseenBounds unseen_bounds(const TriangleMesh& closed, const UnseenParts& parts);

}  // namespace clast::detail

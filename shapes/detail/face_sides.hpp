#pragma once
/// The sides of polygon faces, sorted so that those on one edge stand together.
#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "shapes/sphero_polyhedron.hpp"

namespace clast::shapes_detail {

/// One side of a face, from its corner `corner` to the next. `forward`: it runs from low to high.
struct FaceSide {
  std::uint32_t low = 0, high = 0;  ///< vertices, low <= high
  std::uint32_t face = 0, corner = 0;
  bool forward = false;

  std::uint32_t from() const { return forward ? low : high; }
  std::uint32_t to() const { return forward ? high : low; }
};

/// Sorted by edge, then face, then corner.
inline std::vector<FaceSide> sorted_face_sides(std::span<const SpheroPolyhedron::Face> faces) {
  std::vector<FaceSide> sides;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint32_t k = 0; k < faces[f].size(); ++k) {
      const std::uint32_t from = faces[f][k], to = faces[f][(k + 1) % faces[f].size()];
      sides.push_back({std::min(from, to), std::max(from, to), f, k, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const FaceSide& a, const FaceSide& b) {
    return std::tie(a.low, a.high, a.face, a.corner) < std::tie(b.low, b.high, b.face, b.corner);
  });
  return sides;
}

/// Calls `use(shared)` with the sides on each edge, in order.
template <class Use>
void for_each_shared_edge(std::span<const FaceSide> sorted, Use&& use) {
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].low == sorted[begin].low &&
           sorted[end].high == sorted[begin].high) {
      ++end;
    }
    use(sorted.subspan(begin, end - begin));
    begin = end;
  }
}

/// Are these the two sides of an edge inside a closed, oriented surface?
inline bool are_neighbours(std::span<const FaceSide> shared) {
  return shared.size() == 2 && shared[0].forward != shared[1].forward &&
         shared[0].low != shared[0].high;
}

}  // namespace clast::shapes_detail

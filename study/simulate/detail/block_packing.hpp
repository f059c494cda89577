#pragma once
/// Packing of blocks into a heap without overlaps, for multi-block releases.
#include <optional>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "dem/search/ground_overlap.hpp"
#include "study/simulate/detail/covered_cells.hpp"

namespace clast::study_detail {

struct HeapExtent {
  double area = 0.0;               ///< area of the outline, m^2
  double mean_thickness = 0.0;     ///< mean height above the ground over the outline, m
  double largest_thickness = 0.0;  ///< largest height above the ground, m
};

/// Builds a heap of blocks without dynamics. Blocks are placed one by one, each at the lowest of
/// several random positions. Gaps of about one grid cell remain between blocks.
class BlockPacking {
 public:
  /// Makes an empty heap.
  /// @param ground  must outlive this object
  /// @param outline  plan polygon, local frame, m
  /// @param width  width of the grid cells, m
  /// @throws InputError  if the outline has no area, contains no cell centre, or leaves the terrain
  BlockPacking(const TerrainSurface& ground, std::span<const Vec2> outline, double width);

  void clear();

  /// Places a block on the heap.
  /// @param overlap  overlap of this body with the ground
  /// @param thickness  maximum height of any block point above the ground, m
  /// @return state of the block at rest; empty if there is no place for it
  std::optional<RigidState> place(const RigidBody& body, const GroundOverlap& overlap,
                                  const Quat& orientation, std::optional<double> thickness,
                                  Random& random);

  HeapExtent heap_extent() const;

  /// Returns the area of the cells that are in both outlines, m^2.
  /// @param other  packing with equal cell width
  double overlapping_area(const BlockPacking& other) const;

 private:
  struct Cell {
    double ground = 0.0;  ///< highest ground in the cell, m
    double top = 0.0;     ///< highest point of ground and heap, m
  };
  /// Returns the cell, or null outside the outline.
  const Cell* find(std::int64_t i, std::int64_t j) const;
  /// Returns the height by which a block must be raised to rest on the heap if it is moved by a
  /// number of cells. Empty if it would leave the outline or exceed the thickness.
  std::optional<double> find_rest_height(std::span<const CoveredCell> covered, std::int64_t move_i,
                                         std::int64_t move_j,
                                         std::optional<double> thickness) const;

  double width_;
  std::int64_t first_i_ = 0, first_j_ = 0;  ///< indices of the first cell
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::optional<Cell>> cells_;  ///< row-major; empty outside the outline
  std::vector<std::size_t> inside_;         ///< indices of the cells in the outline
};

}  // namespace clast::study_detail

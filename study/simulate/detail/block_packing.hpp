#pragma once
/// A heap of blocks put together without overlap, for a rock mass that is released at once.
#include <optional>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "dem/search/ground_overlap.hpp"
#include "study/simulate/detail/covered_cells.hpp"

namespace clast::study_detail {

/// How a heap fills its outline.
struct FilledArea {
  double area = 0.0;               ///< of the outline, m^2
  double mean_thickness = 0.0;     ///< of the heap above the ground, over the outline, m
  double largest_thickness = 0.0;  ///< m
};

/// Blocks are let down one by one onto ground and heap, without motion, each at that of several
/// drawn places in the outline where it comes to lie lowest above the ground. Heights are kept cell
/// by cell on the safe side, so gaps of the order of a cell stay between the blocks.
class BlockPacking {
 public:
  /// @param ground   must outlive it
  /// @param outline  plan, local frame, m
  /// @param width    of the cells that heights are kept in, m
  /// @throws InputError  the outline has no area, or covers no cell; where it is off the terrain
  BlockPacking(const TerrainSurface& ground, std::span<const Vec2> outline, double width);

  /// Removes all blocks.
  void clear();

  /// Puts a block on the heap.
  /// @param overlap    of this body with this ground
  /// @param thickness  that no point of the block may be higher above the ground, m
  /// @return  its state, at rest; none: it fits nowhere
  std::optional<RigidState> place(const RigidBody& body, const GroundOverlap& overlap,
                                  const Quat& orientation, std::optional<double> thickness,
                                  Random& random);

  FilledArea filling() const;

  /// Area of the cells that belong to the outlines of both, m^2.
  /// @param other  of the same width
  double overlapping_area(const BlockPacking& other) const;

 private:
  struct Cell {
    double ground = 0.0;  ///< highest ground in it, m
    double top = 0.0;     ///< of ground and heap, m
  };
  /// The cell in the outline; none beyond it.
  const Cell* find(std::int64_t i, std::int64_t j) const;
  /// Height that a block must be raised by to lie on the heap when it is moved by so many cells;
  /// none where it sticks out of the outline or the thickness.
  std::optional<double> find_rest_height(std::span<const CoveredCell> covered, std::int64_t move_i,
                                    std::int64_t move_j, std::optional<double> thickness) const;

  double width_;
  std::int64_t first_i_ = 0, first_j_ = 0;  ///< of the first cell
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::optional<Cell>> cells_;  ///< row by row; none: outside
  std::vector<std::size_t> inside_;         ///< those that there are
};

}  // namespace clast::study_detail

#pragma once
/// Height fields over a grid in plan.
#include <functional>
#include <vector>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Square in plan that is scanned.
struct ScannedPlan {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  ///< m
};

/// A height for each node of a grid in plan.
struct HeightField {
  Vec2 low = Vec2::Zero();
  double cell = 1.0;  ///< m
  int columns = 0, rows = 0;
  std::vector<double> heights;  ///< row by row

  /// Makes a level field at height 0.
  HeightField(const ScannedPlan& plan, double cell_size);

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  Vec2 place(int column, int row) const { return low + cell * Vec2(column, row); }

  /// Returns the height, bilinear between nodes; outside, that of the border.
  double at(const Vec2& place) const;
};

/// Sets the height of every node.
void fill_heights(HeightField& field, unsigned threads,
                  const std::function<double(const Vec2&)>& height);

/// Smooths heights by three box blurs in both directions, nearly a Gaussian.
/// @param reach  half the width of the box, nodes
void smooth_heights(HeightField& field, int reach);

/// Adds pebbles, which are half buried balls of up to three spacings, and gravel that no scan of
/// this spacing resolves.
void add_grains(HeightField& field, double spacing, Random& random);

/// Makes a mesh with two triangles for each cell.
TriangleMesh make_mesh(const HeightField& field);

}  // namespace clast

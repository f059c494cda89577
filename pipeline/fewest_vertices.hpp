#pragma once
/// Search of the block with the fewest vertices within tolerance of its scan.
#include <optional>
#include <string>

#include "library/make_block.hpp"

namespace clast {

/// Searches the number of vertices to about a tenth.
class FewestVerticesSearch {
 public:
  /// Simplifies the scan once to the maximum number of vertices. All arguments must outlive this
  /// object.
  /// @param source  origin of the block; the number of vertices is added to its options
  FewestVerticesSearch(const std::string& id, const ScanSurface& scan, const BlockSource& source);

  /// Returns the block with the fewest vertices within tolerance, with the largest possible radius,
  /// which is halved while no block is within tolerance. If none is, returns the nearest block with
  /// a warning.
  /// @param radius_given  the radius was given by the user and is kept
  /// @throws GeometryError  if no block could be made
  Block find_block(const BlockOptions& options, bool radius_given);

 private:
  std::optional<Block> search_at_radius(const BlockOptions& options);
  std::optional<Block> try_vertex_count(std::size_t count, const BlockOptions& options);
  /// Returns the nearest block tried, or throws the reason if none could be made.
  Block nearest_block(const BlockOptions& options);
  /// Returns the block with mass properties of the requested accuracy.
  Block with_accurate_mass(Block block, const BlockOptions& options) const;
  BlockSource source_with_vertices(std::size_t count) const;
  void keep_nearest(Block block);

  const std::string& id_;
  const ScanSurface& scan_;
  const BlockSource& source_;
  TriangleMesh fine_;
  std::optional<Block> nearest_;
  std::string refusal_;  ///< first error message
};

}  // namespace clast

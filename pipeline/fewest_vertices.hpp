#pragma once
/// Search of the block with the fewest vertices within tolerance of its scan.
#include <optional>
#include <string>

#include "library/make_block.hpp"

namespace clast {

/// Search of the minimum number of vertices, to about a tenth, with which a block is within
/// tolerance of its scan.
class FewestVerticesSearch {
 public:
  /// Simplifies the scan once to the maximum number of vertices. All arguments must outlive it.
  /// @param source  origin of the block, to whose options the number of vertices is added
  FewestVerticesSearch(const std::string& id, const ScanSurface& scan, const BlockSource& source);

  /// Finds the block with the fewest vertices within tolerance. The radius is halved until a block
  /// is within tolerance. If none is, returns the block with the smallest deviation and a warning.
  /// @param radius_given  true if the user gave the radius, which is then not changed
  /// @throws GeometryError  if no block could be made
  Block find_block(const BlockOptions& options, bool radius_given);

 private:
  std::optional<Block> search_at_radius(const BlockOptions& options, std::size_t& first);
  std::optional<Block> try_vertex_count(std::size_t count, const BlockOptions& options);
  /// Returns the block with the smallest deviation so far. Throws the reason if there is none.
  Block nearest_block(const BlockOptions& options);
  /// Returns the block with its mass properties and deviation computed to the requested accuracy.
  Block with_accurate_measures(Block block, const BlockOptions& options) const;
  Block remade(const Block& block, const BlockOptions& options) const;
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

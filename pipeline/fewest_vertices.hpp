#pragma once
/// The block of the fewest vertices that is as near to its scan as asked.
#include <optional>
#include <string>

#include "library/make_block.hpp"

namespace clast {

/// Trials with more and fewer vertices until a tenth fewer are known not to do.
class FewestVerticesSearch {
 public:
  /// Simplifies the scan once, to the most vertices a block is given. All three must outlive the
  /// search.
  /// @param source  of the block; how many vertices it got is added to its options
  FewestVerticesSearch(const std::string& id, const ScanSurface& scan, const BlockSource& source);

  /// The lightest block within the tolerance, with the largest radius that allows one: the radius
  /// is halved where none does. Where none does at any, the nearest block, with a warning.
  /// @param radius_given  by the user: it is kept
  /// @throws GeometryError  no block could be made at all
  Block find_block(const BlockOptions& options, bool radius_given);

 private:
  std::optional<Block> search_at_radius(const BlockOptions& options);
  std::optional<Block> try_vertex_count(std::size_t count, const BlockOptions& options);
  /// The nearest of the blocks that were tried, or, where none could be made, the reason.
  Block nearest_block(const BlockOptions& options);
  /// The same block, its mass as accurate as asked.
  Block with_accurate_mass(Block block, const BlockOptions& options) const;
  BlockSource source_with_vertices(std::size_t count) const;
  void keep_nearest(Block block);

  const std::string& id_;
  const ScanSurface& scan_;
  const BlockSource& source_;
  TriangleMesh fine_;
  std::optional<Block> nearest_;
  std::string refusal_;  ///< the first
};

}  // namespace clast

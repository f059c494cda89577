#pragma once
/// Search of the block with the fewest vertices within tolerance of its scan.
#include <optional>
#include <string>

#include "library/make_block.hpp"

namespace clast {

/// Search of the minimum number of vertices with which a block is within tolerance of its scan.
class FewestVerticesSearch {
 public:
  /// Simplifies the scan once to the maximum number of vertices. All arguments must outlive it.
  /// @param source  origin of the block, to whose options the number of vertices is added
  FewestVerticesSearch(const std::string& id, const ScanSurface& scan, const BlockSource& source);

  /// Finds the block with the fewest vertices within tolerance. The radius is halved until a block
  /// is within tolerance. If none is, returns the block with the smallest deviation and a warning.
  /// @param radius_given  true if the user gave the radius, which is then not changed
  /// @param refinement  the search ends if the number of vertices divided by this is known to be
  /// too
  ///                    few
  /// @throws GeometryError  if no block could be made
  Block find_block(const BlockOptions& options, bool radius_given, double refinement);

 private:
  /// A body fitted with some number of vertices, and the options that it was fitted with.
  struct Trial {
    std::size_t vertices;
    FittedBody fitted;
    BlockOptions options;
  };
  std::optional<Trial> search_at_radius(const BlockOptions& options, std::size_t& first,
                                        bool is_last);
  std::optional<Trial> find_closest(const BlockOptions& options);
  /// @param relaxation  factor of the tolerance
  std::optional<Trial> try_vertex_count(std::size_t count, const BlockOptions& options,
                                        double relaxation = 1.0);
  void keep_nearest(Trial trial);
  Block block_of(const Trial& trial) const;

  const std::string& id_;
  const ScanSurface& scan_;
  const BlockSource& source_;
  TriangleMesh fine_;
  double refinement_ = 1.0;
  std::optional<Trial> nearest_;  ///< trial with the smallest distance found beyond the tolerance
  std::string refusal_;           ///< first error message
};

}  // namespace clast

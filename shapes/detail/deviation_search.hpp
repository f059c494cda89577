#pragma once
/// Search for the largest distances between a rounded body and its scan.
#include <optional>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "mesh/triangle_tree.hpp"
#include "shapes/detail/covering_height.hpp"
#include "shapes/detail/rounded_surface_distance.hpp"
#include "shapes/scan_surface.hpp"

namespace clast::shapes_detail {

/// Search by branch and bound over patches of both surfaces. Results do not depend on the number of
/// threads.
class DeviationSearch {
 public:
  /// Builds the distance tree of the core. All arguments must outlive this object.
  /// @param core  core of the body, closed, outward
  /// @param radius  Minkowski radius, m
  DeviationSearch(const ScanSurface& scan, const TriangleMesh& core, double radius,
                  ThreadPool& threads);

  const TriangleTree& core_tree() const { return tree_; }

  /// Returns the distance of each point from the rounded surface.
  std::vector<SurfaceDistance> distances_from_body(std::span<const Vec3> points);

  /// Limits that end a search early, m.
  struct Limits {
    double accepted = 0.0;   ///< the search ends if no distance can be larger
    double refused = 1e300;  ///< the search ends if a larger distance was found
    double noted = 1e300;    ///< points with larger distances are noted
    /// Number of patches, over that of the first, from which a refused search ends.
    std::size_t least_growth = 1;
  };
  /// Returns an upper bound of the distances of the scan from the rounded surface, m. It exceeds
  /// the largest distance by at most 2e-5 of the diagonal of the scan, if a million patches
  /// suffice. If the search ended early, it is at most `accepted`, or a distance above `refused`.
  /// @param known  a distance that occurs, m
  double scan_to_body(double known, const Limits& limits);
  /// Returns the same bound for the distances of the rounded surface from the scan.
  double body_to_scan(const Limits& limits);

  /// Points of one surface that are far from the other.
  struct DistantPoints {
    std::vector<Vec3> on_scan, on_body;
  };
  /// Finds points whose distance from the other surface is above `distance`, if there are some with
  /// a distance above `limit`; otherwise both lists are empty. The points are at least `distance`
  /// apart, the farthest first.
  /// @param distance  m, at most `limit`
  DistantPoints find_distant_points(double limit, double distance);

 private:
  struct Patch;
  struct PatchBound;
  struct Outcome;
  template <typename Bound>
  Outcome search(std::vector<Patch> patches, double radius, double known, const Limits& limits,
                 const Bound& bound);
  Outcome search_scan(double known, const Limits& limits);
  Outcome search_body(const Limits& limits);
  std::vector<Patch> body_patches() const;
  bool is_near_plane(const Patch& patch, double limit) const;
  std::optional<double> bound_by_height(const Patch& patch, double limit) const;

  const ScanSurface& scan_;
  const TriangleMesh& core_;
  double radius_;
  double gap_;       ///< accuracy of the bounds, m
  double in_plane_;  ///< height above the plane of a face up to which a point lies in it, m
  ThreadPool& threads_;
  TriangleTree tree_;
  RoundedSurfaceDistance surface_;
  CoveringHeight scan_over_;
};

}  // namespace clast::shapes_detail

#pragma once
/// Free space between scanner or camera positions and the points of a deposit.
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruct/deposit/detail/oriented_points.hpp"

namespace clast::reconstruct_detail {

/// Directions of the points of a cloud as seen from known stations. A position is free space if a
/// station sees the surface behind it.
class StationViews {
 public:
  /// Sorts the points by their directions from each station. Of more than twelve stations, twelve
  /// are used that are far from each other.
  /// @param cloud  must outlive the views
  /// @param stations  positions of scanner or cameras, m, relative to the origin of `cloud`
  StationViews(const OrientedPoints& cloud, std::span<const Vec3> stations);

  bool is_empty() const { return views_.empty(); }

  /// True if the surface seen from a station in the direction of `position` lies behind it: there
  /// are points around the line of sight, all of them are farther from the station, and their
  /// normals point towards it.
  /// @param position  m, relative to the origin of the cloud
  /// @param spacing  point spacing near `position`, m
  bool is_free(const Vec3& position, double spacing) const;

 private:
  /// A point in the order of the cells of a view.
  struct Entry {
    std::uint32_t cell;
    std::uint32_t point;
  };
  struct View {
    Vec3 station;
    double cell_side;            ///< in the octahedral map, which has the sides 2
    std::uint32_t columns;       ///< cells along a side of the map
    std::vector<Entry> entries;  ///< ordered by cell, then point
  };
  bool is_free(const View& view, const Vec3& position, double spacing) const;

  const OrientedPoints& cloud_;
  std::vector<View> views_;
};

}  // namespace clast::reconstruct_detail

#pragma once
/// Log of a repair.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "reconstruct/repair/repair_report.hpp"
#include "reconstruct/repair/soup.hpp"

namespace clast::reconstruct_detail {

/// Records defects. Positions are given relative to a local origin and converted for the report.
class RepairLog {
 public:
  /// Starts an empty log.
  /// @param origin  origin of the working coordinates
  /// @param to_reported_position  converts positions to the frame of the report; if empty, they are
  ///                              unchanged
  RepairLog(const Vec3& origin, const std::function<Vec3(const Vec3&)>& to_reported_position)
      : origin_(origin), reported_place_(to_reported_position) {}

  Vec3 to_reported_frame(const Vec3& local) const;
  std::string format_position(const Vec3& local) const;  ///< formats a position for messages

  /// Records a defect unless `count` is 0.
  /// @param area  removed area, m^2
  void add_defect(DefectKind kind, std::size_t count, double area = 0.0,
                  std::optional<Vec3> where = {}, double size = 0.0);
  void add_defect(DefectKind kind, const RepairChange& change);
  void add_duplicate(const DuplicateSurface& copy);

  /// Swaps the volume changes below and above, after the mesh was flipped.
  void flip_orientation();
  /// Adds the hole defect and sorts the defects by kind.
  void finish();

  RepairReport report;
  double area_as_read = 1.0;  ///< area after welding, m^2

 private:
  Vec3 origin_;
  const std::function<Vec3(const Vec3&)>& reported_place_;
};

}  // namespace clast::reconstruct_detail

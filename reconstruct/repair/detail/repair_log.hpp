#pragma once
/// What a repair found and did, noted as it goes on.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "reconstruct/repair/repair_report.hpp"
#include "reconstruct/repair/soup.hpp"

namespace clast::reconstruct_detail {

/// Takes places about a local origin and reports them as the caller wants.
class RepairLog {
 public:
  /// @param origin          of the coordinates that are worked in
  /// @param reported_place  what is reported for a place of the mesh as read; empty: that place
  RepairLog(const Vec3& origin, const std::function<Vec3(const Vec3&)>& reported_place)
      : origin_(origin), reported_place_(reported_place) {}

  Vec3 to_reported_frame(const Vec3& local) const;
  std::string format_position(const Vec3& local) const;  ///< for messages

  /// Nothing where `count` is 0.
  /// @param area  of what was dropped, m^2
  void add_defect(DefectKind kind, std::size_t count, double area = 0.0,
                  std::optional<Vec3> where = {}, double size = 0.0);
  void add_defect(DefectKind kind, const RepairChange& change);
  void add_duplicate(const DuplicateSurface& copy);

  /// The same of the surface turned over.
  void flip_orientation();
  /// Adds what the holes come to, and puts defects in the order of their kinds.
  void finish();

  RepairReport report;
  double area_as_read = 1.0;  ///< of the surface after welding, m^2

 private:
  Vec3 origin_;
  const std::function<Vec3(const Vec3&)>& reported_place_;
};

}  // namespace clast::reconstruct_detail

#pragma once
/// Images of a scan: as read, closed, and its deviation from the block. If `metric` is false,
/// lengths are labelled as units of an unscaled model.
#include <functional>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "report/blocks/mesh_picture.hpp"

namespace clast::report_detail {

/// Label at a position of the scan, in file coordinates.
struct PositionMark {
  std::string label;
  Vec3 place = Vec3::Zero();
};

/// Draws the scan as read beside the closed scan from three directions, with hole borders, filled
/// surface and numbered `marks`.
/// @param raw  as read
/// @param options  used for reading
std::string draw_before_and_after(const TriangleMesh& raw, const ScanOptions& options,
                                  const FieldBlock& block, const std::vector<PositionMark>& marks,
                                  bool metric = true);

/// Draws the block coloured by its distance from the scan, with a colour bar.
/// @param skin  surface of the block
/// @param scan  closed, in the same frame
/// @param reach  distance of the extreme colours, m
std::string draw_deviation_map(const TriangleMesh& skin, const TriangleMesh& scan, double reach,
                               bool metric = true);

/// Draws a surface from three directions, each triangle in its colour.
/// @param colour  colour of a triangle by index
std::string draw_coloured_views(const TriangleMesh& mesh,
                                const std::function<Rgb(std::uint32_t)>& colour,
                                const std::string& caption, bool metric = true);

}  // namespace clast::report_detail

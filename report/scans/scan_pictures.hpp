#pragma once
/// Images of a scan before and after its repair, and of the distance between block and scan. If
/// `metric` is false, the scan has no known scale, and lengths are in units of the model.
#include <functional>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "report/blocks/mesh_picture.hpp"

namespace clast::report_detail {

/// Label at a position of the scan, in file coordinates.
struct PositionMark {
  std::string label;
  Vec3 position = Vec3::Zero();
};

/// Draws a scan before and after its repair from three directions, with borders of holes, filled
/// surface and labelled positions.
/// @param raw  scan before its repair
/// @param options  options used for reading the scan
std::string draw_before_and_after(const TriangleMesh& raw, const ScanOptions& options,
                                  const FieldBlock& block, const std::vector<PositionMark>& marks,
                                  bool metric = true);

/// Draws the block coloured by its distance from the scan, with a colour bar.
/// @param skin  surface of the block
/// @param scan  closed scan, in the frame of `skin`
/// @param reach  distance of the extreme colours, m
std::string draw_deviation_map(const TriangleMesh& skin, const TriangleMesh& scan, double reach,
                               bool metric = true);

/// Draws a block of joined scans coloured by the distance of their surfaces, with a colour bar.
/// @param distances  m, one per vertex; NaN where one scan alone observed the block
/// @param reach  distance of the extreme colour, m
std::string draw_join_map(const TriangleMesh& block, const std::vector<double>& distances,
                          double reach);

/// Draws a surface with coloured triangles from three directions.
/// @param colour  function that returns the colour of a triangle
std::string draw_coloured_views(const TriangleMesh& mesh,
                                const std::function<Rgb(std::uint32_t)>& colour,
                                const std::string& caption, bool metric = true);

}  // namespace clast::report_detail

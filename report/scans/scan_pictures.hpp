#pragma once
/// The pictures of a scan's page: as it was read, closed, and how far the block is off it. Where
/// `metric` is false, lengths in them are called units: those of a model without a scale.
#include <functional>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "report/blocks/mesh_picture.hpp"

namespace clast::report_detail {

/// A number at a place of the scan, in the coordinates of its file.
struct PositionMark {
  std::string label;
  Vec3 place = Vec3::Zero();
};

/// The scan as it was read beside the closed one, from three sides, as a section of a page: borders
/// of holes and what was filled in stand out, `marks` are numbered.
/// @param raw      as read
/// @param options  with which it was read
std::string draw_before_and_after(const TriangleMesh& raw, const ScanOptions& options,
                             const FieldBlock& block, const std::vector<PositionMark>& marks,
                             bool metric = true);

/// The block's surface coloured by its distance from the scan, with a colour bar, as a figure.
/// @param skin   surface of the block
/// @param scan   closed; in the same frame
/// @param reach  distance of the darkest colours, m
std::string draw_deviation_map(const TriangleMesh& skin, const TriangleMesh& scan, double reach,
                          bool metric = true);

/// A surface from three sides as a figure, each triangle in its colour.
/// @param colour  of a triangle, by its number
std::string painted_views(const TriangleMesh& mesh, const std::function<Rgb(std::uint32_t)>& colour,
                          const std::string& caption, bool metric = true);

}  // namespace clast::report_detail

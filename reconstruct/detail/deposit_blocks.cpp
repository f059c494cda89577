#include "reconstruct/detail/deposit_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "mesh/surface_samples.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/detail/cloud_blocks.hpp"
#include "reconstruct/detail/mesh_blocks.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Smallest blocks that a scan resolves, in point spacings.
constexpr double kResolvedSpacings = 12.0;

constexpr std::size_t kMinSurfaceSamples = 60000;  ///< of a mesh

std::string list_contacts(const std::vector<std::uint32_t>& contacts) {
  std::string list;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    list += (i == 0 ? "" : i + 1 == contacts.size() ? " and " : ", ");
    list += std::to_string(contacts[i] + 1);
  }
  return list;
}

/// Sizes of the blocks that a scan resolves, as the end of a sentence.
std::string describe_resolution(std::size_t points, double spacing) {
  return std::to_string(points) + " points with a spacing of " + format_significant(spacing, 2) +
         " m show blocks from about " + format_significant(kResolvedSpacings * spacing, 2) + " m";
}

/// Number of the parts that were left out, to follow "no part of the scan is a block".
std::string describe_left_out(const std::vector<LeftOutPart>& parts) {
  if (parts.empty()) return "";
  const auto largest = std::max_element(
      parts.begin(), parts.end(),
      [](const LeftOutPart& a, const LeftOutPart& b) { return a.points < b.points; });
  return " (" + format_count(parts.size(), "part") +
         " left out, the largest because of: " + name_of(largest->reason) + ")";
}

FieldBlock field_block(DepositBlock block, const std::vector<std::string>& notes) {
  FieldBlock found;
  found.scan.mesh = std::exchange(block.body, {});
  found.scan.notes = notes;
  found.scan.notes.push_back("made from " + std::to_string(block.points.size()) + " points, " +
                             format_significant(100.0 * block.visible_fraction, 2) +
                             " % of its surface is visible; the rest is estimated");
  if (!block.contacts.empty()) {
    found.scan.notes.push_back((block.contacts.size() == 1 ? "touches block " : "touches blocks ") +
                               list_contacts(block.contacts) + " of this scan");
  }
  found.bounds = std::exchange(block.bounds, {});
  found.in_deposit = std::move(block);
  return found;
}

}  // namespace

FieldDeposit extract_deposit(const std::vector<Vec3>& raw, const std::string& name,
                             const FieldScanOptions& options) {
  CleanCloud clean = clean_cloud(raw, name, options.scan.unit);
  for (Vec3& p : clean.points) {
    p *= options.scan.unit;
    if (options.scan.up == "y") p = y_up_to_z_up(p);
  }
  Deposit deposit = segment_deposit(clean.points, {.smallest_axis = options.smallest_axis,
                                                   .edits = options.edits,
                                                   .threads = options.surface.threads,
                                                   .progress = options.progress});
  if (deposit.blocks.empty()) {
    throw GeometryError(name + ": no part of the scan is a block" +
                        describe_left_out(deposit.left_out) + "; " +
                        describe_resolution(raw.size(), deposit.spacing) +
                        "; scan more densely, or, if this is one block alone, leave `split` out");
  }
  FieldDeposit found;
  const double resolved = kResolvedSpacings * deposit.spacing;
  if (options.smallest_axis > 0.0 && options.smallest_axis < resolved) {
    found.notes.push_back("`smallest_axis` is " + format_significant(options.smallest_axis, 4) +
                          " m, but " + describe_resolution(raw.size(), deposit.spacing) +
                          "; smaller ones need a spacing of " +
                          format_significant(options.smallest_axis / kResolvedSpacings, 2) + " m");
  }
  found.left_out = std::move(deposit.left_out);
  found.spacing = deposit.spacing;
  found.block_of_point.assign(raw.size(), 0);
  for (std::size_t b = 0; b < deposit.blocks.size(); ++b) {
    for (std::uint32_t& i : deposit.blocks[b].points) {
      i = static_cast<std::uint32_t>(clean.sources[i]);
      found.block_of_point[i] = static_cast<std::uint32_t>(b + 1);
    }
    found.blocks.push_back(field_block(std::move(deposit.blocks[b]), clean.notes));
  }
  for (std::size_t i = 0; i < raw.size(); ++i) {
    found.block_of_point[i] = found.block_of_point[clean.first_duplicates[i]];
  }
  return found;
}

FieldDeposit extract_deposit(const TriangleMesh& raw, const std::string& name,
                             const FieldScanOptions& options) {
  FieldDeposit found;
  if (is_closed_body(raw, options.scan)) {
    if (!options.edits.empty()) {
      throw InputError(name +
                       ": the mesh is a closed body, hence one block, which `edits` cannot "
                       "change; leave them out");
    }
    found.blocks = extract_mesh_blocks(raw, name, options);
    found.block_of_point.assign(raw.vertices.size(), 1);
    return found;
  }
  const std::vector<Vec3> points =
      sample_surface(raw, std::max(kMinSurfaceSamples, raw.vertices.size()));
  found = extract_deposit(points, name, options);
  const PointTree tree(points);
  std::vector<std::uint32_t> block_of_vertex;
  for (const Vec3& vertex : raw.vertices) {
    block_of_vertex.push_back(
        found.block_of_point[tree.nearest_neighbours(vertex, 1).front().point]);
  }
  found.block_of_point = std::move(block_of_vertex);
  found.spacing *=
      std::sqrt(static_cast<double>(points.size()) / static_cast<double>(raw.vertices.size()));
  return found;
}

}  // namespace clast::reconstruct_detail

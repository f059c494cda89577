#include "reconstruct/field_scan.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/point_cloud.hpp"
#include "reconstruct/detail/cloud_blocks.hpp"
#include "reconstruct/detail/deposit_blocks.hpp"
#include "reconstruct/detail/mesh_blocks.hpp"
#include "reconstruct/detail/stored_digits.hpp"
#include "reconstruct/registration/passes.hpp"

namespace clast {

namespace {

bool is_cloud(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  const std::vector<std::string>& known = cloud_extensions();
  return extension == ".asc" || std::find(known.begin(), known.end(), extension) != known.end();
}

/// Refuses coordinates that are not lengths in the unit of the options; the user's unit holds
/// against what the file says, with a note.
std::vector<std::string> check_cloud_system(const std::filesystem::path& path,
                                            const CloudSummary& summary, const Bounds& box,
                                            const ScanOptions& options) {
  constexpr double kCorrection = 0.05;  // factors nearer to 1 correct metres, and are no unit
  const bool metres = std::abs(options.unit - 1.0) <= kCorrection;
  const LengthUnitRequirements use{
      .unit = metres ? 1.0 : options.unit,
      .unit_given = !metres,
      .needs_z_up = false,
      .conversion_command = "pdal translate, filters.reprojection, EPSG:CODE",
      .correction_command = "pdal translate, writers.las.a_srs=EPSG:CODE",
      .has_units_option = true};
  std::vector<std::string> notes =
      check_length_units(path.string(), summary.unit_declarations, use);
  if (summary.point_count > 0) {
    check_map_scale(path.string(), summary.crs, ((box.low + box.high) / 2.0).head<2>(),
                    use.conversion_command);
  }
  return notes;
}

}  // namespace

void FieldScanOptions::check() const {
  scan.check();
  surface.check();
}

std::vector<FieldBlock> extract_field_blocks(const TriangleMesh& raw, const std::string& name,
                                             const FieldScanOptions& options) {
  options.check();
  if (options.split) return extract_deposit_blocks(raw, name, options).blocks;
  return reconstruct_detail::extract_mesh_blocks(raw, name, options);
}

std::vector<FieldBlock> extract_field_blocks(const std::vector<Vec3>& points,
                                             const std::string& name,
                                             const FieldScanOptions& options) {
  options.check();
  if (options.split) return extract_deposit_blocks(points, name, options).blocks;
  return reconstruct_detail::extract_cloud_blocks(points, name, options);
}

FieldDeposit extract_deposit_blocks(const std::vector<Vec3>& points, const std::string& name,
                                    const FieldScanOptions& options) {
  options.check();
  return reconstruct_detail::extract_deposit(points, name, options);
}

FieldDeposit extract_deposit_blocks(const TriangleMesh& raw, const std::string& name,
                                    const FieldScanOptions& options) {
  options.check();
  return reconstruct_detail::extract_deposit(raw, name, options);
}

RawScan read_raw_scan(const std::filesystem::path& path, const ScanOptions& as_given) {
  RawScan read;
  read.scan = resolve_scan_options(path, as_given);
  CloudSummary summary;
  std::vector<PointRecording> recordings;
  if (is_cloud(path)) {
    summary = stream_cloud(
        path,
        [&](const PointBatch& batch) {
          read.mesh.vertices.insert(read.mesh.vertices.end(), batch.points.begin(),
                                    batch.points.end());
          recordings.insert(recordings.end(), batch.recordings.begin(), batch.recordings.end());
        },
        read.scan.columns);
  } else if (!read.scan.columns.empty()) {
    throw InputError(path.string() + ": `columns` applies only to clouds in text; leave it out");
  } else {
    read.mesh = read_mesh_or_points(path);
  }
  read.passes = number_passes(recordings);
  read.crs = summary.crs;
  const std::vector<std::string> system_notes =
      check_cloud_system(path, summary, bounds(read.mesh), read.scan);
  const std::string note =
      reconstruct_detail::check_coordinate_digits(read.mesh, path, read.scan.unit);
  if (!note.empty()) read.notes.push_back(note);
  read.notes.insert(read.notes.end(), system_notes.begin(), system_notes.end());
  const auto left_out = [&](std::size_t count, const char* why) {
    if (count > 0) read.notes.push_back(std::to_string(count) + " points left out: " + why);
  };
  left_out(summary.non_finite_points, "a coordinate is not finite");
  left_out(summary.withheld_points, "the file flags them as withheld or classes them as noise");
  return read;
}

FieldScan read_field_scan(const std::filesystem::path& path, const FieldScanOptions& as_given) {
  as_given.check();
  RawScan read = read_raw_scan(path, as_given.scan);
  FieldScanOptions options = as_given;
  options.scan = read.scan;
  FieldScan scan;
  scan.raw = std::move(read.mesh);
  scan.crs = read.crs;
  if (options.split) {
    static_cast<FieldDeposit&>(scan) =
        scan.raw.triangles.empty()
            ? extract_deposit_blocks(scan.raw.vertices, path.string(), options)
            : extract_deposit_blocks(scan.raw, path.string(), options);
  } else if (scan.raw.triangles.empty()) {
    scan.blocks = extract_field_blocks(scan.raw.vertices, path.string(), options);
  } else {
    scan.blocks = extract_field_blocks(scan.raw, path.string(), options);
  }
  for (FieldBlock& block : scan.blocks) {
    block.scan.notes.insert(block.scan.notes.end(), read.notes.begin(), read.notes.end());
  }
  return scan;
}

}  // namespace clast

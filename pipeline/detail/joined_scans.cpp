#include "pipeline/detail/joined_scans.hpp"

#include <utility>

#include "core/error.hpp"
#include "core/files/up_axis.hpp"
#include "core/utf8.hpp"

namespace clast::pipeline_detail {

namespace {

/// Photographs as points in metres.
ScanToJoin read_photographs(const std::filesystem::path& folder, const ScanToBlockOptions& options,
                            bool needs_scale, std::vector<std::string>& notes,
                            const ScanCallbacks& callbacks) {
  PhotoScanOptions photos = options.photos;
  if (options.scale_points || options.scan.unit != 1.0) photos.metres_per_unit = options.scan.unit;
  photos.allow_unscaled = !needs_scale;  // stored scales must agree
  PhotoScan scan = reconstruct_from_photos(
      folder, photos, [&](const std::string& what) { callbacks.begin_step(what, true); });
  for (const std::string& note : scan.notes) notes.push_back(folder.string() + ": " + note);
  ScanToJoin joining;
  joining.raw.vertices = std::move(scan.cloud.points);
  joining.scan.up = "z";
  return joining;
}

std::string name_of_scan(const std::filesystem::path& path) {
  const std::filesystem::path name =
      path.has_filename() ? path.filename() : path.parent_path().filename();
  return to_utf8(name.string());
}

/// Index of the scan with a path, name or stem.
std::size_t find_scan(const std::vector<std::filesystem::path>& paths, const std::string& name) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::filesystem::path& path = paths[i];
    if (path == std::filesystem::path(name)) return i;
    if (name_of_scan(path) == name || to_utf8(path.stem().string()) == name) found.push_back(i);
  }
  if (found.size() == 1) return found[0];
  std::string known;
  for (const std::filesystem::path& path : paths) {
    known += (known.empty() ? "" : ", ") + to_utf8(path.string());
  }
  throw InputError("\"" + name + "\" is the name of " + (found.empty() ? "none" : "several") +
                   " of the joined scans (" + known + "); name one by its path");
}

Quat rotation_of(const Vec3& angles) {
  return Quat(Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) *
              Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
              Eigen::AngleAxisd(angles.x(), Vec3::UnitX()));
}

RegistrationOptions registration_options(const std::vector<std::filesystem::path>& paths,
                                         const std::vector<ScanToJoin>& scans,
                                         const ScanToBlockOptions& options,
                                         const ScanCallbacks& callbacks) {
  RegistrationOptions registration;
  registration.threads = options.block.threads;
  registration.progress = callbacks.progress;
  registration.free_scale = options.join.free_scale;
  for (const NamedPose& pose : options.join.poses) {
    registration.hints.push_back({find_scan(paths, pose.scan), rotation_of(pose.angles)});
  }
  const auto in_metres = [&](std::size_t scan, const Vec3& point) {
    const Vec3 scaled_point = scans[scan].scan.unit * point;
    return scans[scan].scan.up == "y" ? y_up_to_z_up(scaled_point) : scaled_point;
  };
  for (const NamedPair& pair : options.join.pairs) {
    const std::size_t a = find_scan(paths, pair.scan_a), b = find_scan(paths, pair.scan_b);
    registration.pairs.push_back({a, b, in_metres(a, pair.point_a), in_metres(b, pair.point_b)});
  }
  return registration;
}

}  // namespace

JoinedScan read_joined_scans(const std::vector<std::filesystem::path>& paths, const std::string& id,
                             const ScanToBlockOptions& options, const FieldScanOptions& reading,
                             const ScanCallbacks& callbacks) {
  std::vector<ScanToJoin> scans;
  std::vector<std::string> notes;
  for (const std::filesystem::path& path : paths) {
    callbacks.begin_step("reading " + to_utf8(path.string()));
    if (std::filesystem::is_directory(path)) {
      scans.push_back(read_photographs(path, options, scans.empty() || !options.join.free_scale,
                                       notes, callbacks));
    } else {
      RawScan read = read_raw_scan(path, options.scan);
      for (const std::string& note : read.notes) notes.push_back(path.string() + ": " + note);
      scans.push_back({{}, std::move(read.mesh), std::move(read.scan)});
    }
    scans.back().name = name_of_scan(path);
  }
  for (std::size_t i = 0; i < scans.size(); ++i) {  // equal names say nothing
    for (std::size_t j = 0; j < i; ++j) {
      if (name_of_scan(paths[i]) == name_of_scan(paths[j])) {
        scans[i].name = to_utf8(paths[i].string());
        scans[j].name = to_utf8(paths[j].string());
      }
    }
  }
  JoinedScan joined =
      join_scans(scans, id, reading, registration_options(paths, scans, options, callbacks));
  std::vector<std::string>& all = joined.block.scan.notes;
  all.insert(all.end(), notes.begin(), notes.end());
  return joined;
}

}  // namespace clast::pipeline_detail

// The extension clast._reconstruct: what needs PCL and OpenCV. It is loaded by the first call.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "library/block_ranges.hpp"
#include "pipeline/board_file.hpp"
#include "pipeline/deposit_edits_file.hpp"
#include "pipeline/picked_pairs_file.hpp"
#include "pipeline/scan_batch.hpp"
#include "pipeline/shape_to_block.hpp"
#include "pipeline/stations_file.hpp"
#include "python/arrays.hpp"
#include "python/options.hpp"
#include "python/values.hpp"
#include "python/watched_call.hpp"
#include "report/scans/scan_report.hpp"

namespace clast::python_detail {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

/// Metres per unit of a scan in which two points are so far apart.
double measured_unit(const std::array<Vec3, 2>& points, double metres) {
  if (!kBlockLengthRange.contains(metres)) {
    throw InputError("scale_length = " + format_significant(metres, 6) + " m must be " +
                     kBlockLengthRange.describe());
  }
  const double units = (points[1] - points[0]).norm();
  if (!(units > 0.0) || !kLengthUnitRange.contains(metres / units)) {
    throw InputError("scale_length: the points are " + format_significant(units, 6) +
                     " units apart, but a unit must be " + kLengthUnitRange.describe());
  }
  return metres / units;
}

void take_scale(Keywords& given, ScanToBlockOptions& options) {
  double unit = 1.0;
  if (given.has("scale_length")) {
    if (given.has("units")) {
      throw InputError("units and scale_length both give the scale; leave one out");
    }
    const auto [a, b, metres] =
        py::cast<std::tuple<py::object, py::object, double>>(given.given_object("scale_length"));
    options.scale_points = {parse_vector(a, "scale_length"), parse_vector(b, "scale_length")};
    unit = measured_unit(*options.scale_points, metres);
  } else {
    given.read("units", options.units);
    unit = parse_length_unit(options.units);
  }
  given.read("scale_factor", options.scale_factor);
  if (!kScaleFactorRange.contains(options.scale_factor)) {
    throw InputError("scale_factor = " + format_significant(options.scale_factor, 6) + " must be " +
                     kScaleFactorRange.describe());
  }
  options.scan.unit = unit * options.scale_factor;
}

void take_scan(Keywords& given, ScanToBlockOptions& options) {
  options.up_given = given.has("up");
  given.read("up", options.scan.up);
  options.scan.columns = given.read_texts("columns");
  if (given.has("ground")) {
    const auto ground = py::cast<std::string>(given.given_object("ground"));
    if (ground != "auto" && ground != "none") {
      throw InputError("ground = \"" + ground + "\" must be \"auto\" or \"none\"");
    }
    options.find_ground = ground == "auto";
  }
  given.read("split", options.split);
  given.read("align", options.align);
  given.read("smallest", options.smallest_axis);
  std::optional<fs::path> edits, stations, labelled;
  given.read("edits", edits);
  if (edits) options.edits = read_deposit_edits(*edits);
  given.read("stations", stations);
  if (stations) options.stations = read_stations(*stations);
  given.read("labelled", labelled);
  if (labelled) options.labelled = *labelled;
  given.read("any_size", options.allow_any_size);
  given.read("keep_inner_shells", options.scan.repair.keep_inner_shells);
}

void take_block(Keywords& given, ScanToBlockOptions& options) {
  BlockOptions& block = options.block;
  options.radius_given = given.has("radius") || given.has("radius_share");
  block.density_given = given.has("density");
  given.read("vertices", options.vertices);
  given.read("radius", block.radius);
  given.read("radius_share", block.radius_fraction);
  given.read("core", block.core);
  given.read("convex", block.convex);
  given.read("density", block.density);
  given.read("mass", block.mass);
  given.read("accuracy", block.accuracy);
  given.read("tolerance", block.tolerance);
  if (block.radius && given.has("radius_share")) {
    throw InputError("radius and radius_share both give the rounding; leave one out");
  }
}

void take_photos(Keywords& given, PhotoScanOptions& photos) {
  std::vector<std::tuple<int, int, double>> bars;
  given.read("scale_bar", bars);
  for (const auto& [first, second, length] : bars) {
    photos.scale.bars.push_back({first, second, length});
  }
  std::optional<fs::path> board;
  given.read("board", board);
  if (board) photos.scale.board = read_scale_board(*board);
  double minutes = photos.colmap.time_limit / 60.0;
  given.read("marker_size", photos.scale.marker_side);
  given.read("markers", photos.markers.dictionary);
  given.read("allow_unscaled", photos.allow_unscaled);
  given.read("model", photos.model);
  given.read("masks", photos.dense.masks);
  given.read("colmap", photos.colmap.program);
  given.read("colmap_minutes", minutes);
  given.read("photo_cache", photos.colmap.cache);
  photos.colmap.time_limit = 60.0 * minutes;
  photos.check();
}

/// Rotations in degrees and picked places of joined scans.
void take_join(Keywords& given, JoinOptions& join) {
  std::map<std::string, std::array<double, 3>> poses;
  given.read("pose", poses);
  for (const auto& [scan, degrees] : poses) {
    join.poses.push_back({scan, Vec3(degrees[0], degrees[1], degrees[2]) / kDegreesPerRadian});
  }
  std::string scale = "stored";
  given.read("scale", scale);
  if (scale != "stored" && scale != "free") {
    throw InputError("scale: \"" + scale + "\" is neither \"stored\" nor \"free\"");
  }
  join.free_scale = scale == "free";
  std::optional<fs::path> picked;
  given.read("picked", picked);
  if (picked) join.pairs = read_picked_pairs(*picked);
}

ScanToBlockOptions options_from(Keywords& given) {
  ScanToBlockOptions options;
  take_join(given, options.join);
  take_scale(given, options);
  take_scan(given, options);
  take_block(given, options);
  take_photos(given, options.photos);
  given.check_all_used();
  options.check();
  return options;
}

py::list shared_list(std::vector<Block> blocks) {
  py::list list;
  for (Block& block : blocks) list.append(std::make_shared<Block>(std::move(block)));
  return list;
}

/// The blocks of one scan: more than one with `split` only.
py::list of_scan(const std::string& scan, const std::optional<std::string>& id,
                 const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  const ScanToBlockOptions options = options_from(given);
  return shared_list(run_with_progress(progress, [&](const ProgressCallback& step) {
    const std::vector<ScanFile> scans = list_scans({scan});
    if (scans.size() != 1) {
      throw InputError(scan + ": holds " + format_count(scans.size(), "scan") +
                       "; reconstruct_batch makes a library of them");
    }
    const ScanFile& one = scans.front();
    const std::string name = id.value_or(one.id);
    const ScanCallbacks callbacks = {.progress = step};
    if (!one.is_shp()) return reconstruct_blocks(one.path, name, options, callbacks);
    const ShpShape shape = one.shape ? *one.shape : read_shp(one.path).front();
    return std::vector<Block>{make_shape_block(shape, one.path, name, options, callbacks)};
  }));
}

/// The block that several scans show.
std::shared_ptr<Block> of_joined(const py::object& scans, const std::string& id,
                                 const py::dict& keywords, const py::object& progress) {
  const std::vector<std::string> inputs = parse_texts(scans, "scan");
  Keywords given(keywords);
  const ScanToBlockOptions options = options_from(given);
  return std::make_shared<Block>(run_with_progress(progress, [&](const ProgressCallback& step) {
    return reconstruct_joined_block(list_joined_scans(inputs, id).paths(), id, options,
                                    {.progress = step});
  }));
}

/// The same of arrays; without triangles they are points.
py::list of_mesh(const py::object& vertices, const py::object& triangles, const std::string& id,
                 const py::dict& keywords, const py::object& progress) {
  TriangleMesh mesh;
  if (triangles.is_none()) {
    mesh.vertices = parse_points(vertices, "vertices");
  } else {
    mesh = parse_mesh(vertices, triangles);
  }
  Keywords given(keywords);
  const ScanToBlockOptions options = options_from(given);
  return shared_list(run_with_progress(progress, [&](const ProgressCallback& step) {
    return reconstruct_mesh_blocks(mesh, id, options, {.progress = step});
  }));
}

/// Keeps what failed and what is to be known, and writes pages where they are wanted.
class Follower : public ScanBatchObserver {
 public:
  Follower(std::size_t scans, const ScanBatchOptions& options, const std::optional<fs::path>& pages)
      : scans_(scans), options_(options), folder_(pages.value_or(fs::path())) {
    if (pages) pages_.emplace(*pages, options.replace || options.resume);
  }

  void on_block_made(const Block& block, const BlockOrigin& origin) override {
    if (!pages_) return;
    pages_->prepare(block, {.raw = origin.raw,
                            .field_block = origin.field_block,
                            .options = options_.scan.scan,
                            .up = origin.up,
                            .scale = "one unit of the file is " +
                                     format_significant(options_.scan.scan.unit, 6) + " m",
                            .density_given = options_.scan.block.density_given,
                            .joined = origin.joined,
                            .photos = origin.photos});
  }
  void on_deposit_made(const ScanFile& scan, const std::vector<Block>& blocks,
                       const DepositOrigin& origin) override {
    if (!pages_) return;
    pages_->prepare_deposit(
        {.name = scan.id,
         .file = scan.path.string(),
         .scan = origin.scan,
         .unit = origin.unit,
         .up = origin.up,
         .ids = origin.ids,
         .blocks = &blocks,
         .edits = options_.scan.edits,
         .stem = scans_ == 1 ? "deposit" : "deposit_" + scan.id,
         .next_command = "clast.reconstruct_batch(\"" + scan.path.string() + "\", \"" +
                         options_.library.string() +
                         "\", split=True, edits=\"edits.json\", replace=True, report=\"" +
                         folder_.string() + "\")"});
  }
  void on_block_added(const Block& block) override {
    ids.push_back(block.id);
    if (pages_) pages_->add(block);
  }
  void on_block_retained(const Block& block) override {
    if (pages_) pages_->add_earlier(block);
  }
  void on_block_refused(const std::string& id) override { std::erase(ids, id); }
  void on_scan_failed(const ScanFile& scan, const std::string& reason) override {
    if (pages_) pages_->add_failure(scan.path.string(), reason);
    failures.emplace_back(scan.path.string(), reason);
  }
  void on_note(const std::string& text) override { notes.push_back(text); }

  void finish() {
    if (pages_) pages_->finish();
  }

  std::vector<std::string> ids, notes;
  std::vector<std::pair<std::string, std::string>> failures;

 private:
  std::size_t scans_;
  const ScanBatchOptions& options_;
  fs::path folder_;  ///< of pages
  std::optional<ScanReport> pages_;
};

/// {added: ids, skipped, failed: [(scan, reason)], notes, blocks}
py::dict batch(const py::object& scans, const fs::path& output, const py::dict& batch_keywords,
               const py::dict& keywords, const py::object& progress) {
  using namespace pybind11::literals;
  const std::vector<std::string> inputs = parse_texts(scans, "scans");
  ScanBatchOptions options;
  options.library = output;
  Keywords given(batch_keywords), of_scans(keywords);
  std::optional<fs::path> pages;
  given.read("jobs", options.jobs);
  given.read("replace", options.replace);
  given.read("resume", options.resume);
  given.read("report", pages);
  std::string join;
  bool join_folders = false;
  given.read("join", join);
  given.read("join_folders", join_folders);
  given.check_all_used();
  options.scan = options_from(of_scans);
  std::optional<Follower> follower;
  const ScanBatchResult result = run_with_progress(progress, [&](const ProgressCallback& step) {
    const std::vector<ScanFile> files = !join.empty()
                                            ? std::vector<ScanFile>{list_joined_scans(inputs, join)}
                                        : join_folders ? list_joined_folders(inputs)
                                                       : list_scans(inputs);
    options.check(files.size());
    follower.emplace(files.size(), options, pages);
    const ScanBatchResult made = reconstruct_scan_batch(files, options, *follower, step);
    follower->finish();
    return made;
  });
  return py::dict("added"_a = follower->ids, "skipped"_a = result.skipped,
                  "failed"_a = follower->failures, "notes"_a = follower->notes,
                  "blocks"_a = result.blocks);
}

}  // namespace

}  // namespace clast::python_detail

PYBIND11_MODULE(_reconstruct, module) {
  using namespace clast::python_detail;
  pybind11::module_::import("clast._core");  // has the types of what is returned
  module.def("of_scan", &of_scan);
  module.def("of_joined", &of_joined);
  module.def("of_mesh", &of_mesh);
  module.def("batch", &batch);
}

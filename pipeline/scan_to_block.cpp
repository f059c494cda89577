#include "pipeline/scan_to_block.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/utf8.hpp"
#include "library/block_bracket.hpp"
#include "massprops/solid.hpp"
#include "mesh/labelled_cloud.hpp"
#include "mesh/mesh_io.hpp"
#include "pipeline/detail/crossing_warning.hpp"
#include "pipeline/detail/joined_scans.hpp"
#include "pipeline/detail/photographed_blocks.hpp"
#include "pipeline/detail/scan_scale.hpp"
#include "pipeline/fewest_vertices.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/oriented_box.hpp"
#include "shapes/surface_deviation.hpp"

namespace clast {

using namespace pipeline_detail;

namespace {

/// Precision of the number of vertices of a block of a complete scan, and of one of which a side is
/// estimated.
constexpr double kScanRefinement = 1.1, kDepositRefinement = 1.5;

/// The hull in place of the scan, and what that adds to the rock.
TriangleMesh hull_instead(const TriangleMesh& scan, std::vector<std::string>& notes) {
  TriangleMesh hull = convex_hull(scan.vertices);
  const double added =
      solid_mass_properties(hull, 1.0).volume / solid_mass_properties(scan, 1.0).volume - 1.0;
  const SurfaceDeviation gap = measure_surface_deviation(scan, make_sphero_polyhedron(hull, 0.0));
  notes.push_back(
      "the convex hull was used, as requested: it has " + format_rounded(100.0 * added, 3) +
      " % more volume than the scan and lies up to " + format_rounded(gap.hausdorff, 3) +
      " m off it; distances and moments below are relative to the hull");
  return hull;
}

/// Adds what the scan leaves open.
void add_unseen(Block& block, const VolumeBracket& bounds) {
  block.volume_bracket = bounds;
  block.warnings.insert(block.warnings.begin(), describe_volume_bracket(block));
}

/// Warning about a tolerance probably not meant as a fraction of L; empty for usual values.
std::string wide_tolerance_note(const BlockOptions& options, const Block& block) {
  constexpr double kWidest = 0.1;
  if (options.tolerance <= kWidest || options.core) return {};
  return "`tolerance` " + format_significant(options.tolerance, 4) +
         " is a fraction of L and allows the block to lie " +
         format_rounded(options.tolerance * block.box.lengths[0], 3) +
         " m off its scan; it is not a length or a percentage: 0.01 means 1 %";
}

/// Tolerance below which the points of a block show no detail, as a fraction of L.
double resolved_tolerance(const FieldBlock& found) {
  constexpr double kSpacings = 0.5;
  if (!found.in_deposit) return 0.0;
  return kSpacings * found.in_deposit->spacing / found.in_deposit->sides[0];
}

/// Simplifies and measures one block of a scan.
Block make_scan_block(FieldBlock& found, const std::string& id, BlockSource source,
                      const ScanToBlockOptions& options, const ScanCallbacks& callbacks) {
  Scan& scan = found.scan;
  if (!source.unscaled) check_scan_size(bounds(scan.mesh), id, options);
  if (scan.report.filled_fraction > 0.0) {
    source.options += " invented_share=" + format_significant(scan.report.filled_fraction, 4);
  }
  if (options.block.convex) {
    scan.mesh = hull_instead(scan.mesh, scan.notes);
    if (found.in_deposit) found.in_deposit->is_observed.clear();
  }
  const ScanSurface surface(scan.mesh);
  BlockOptions making = options.block;
  making.tolerance = std::max(making.tolerance, resolved_tolerance(found));
  Block block;
  if (options.block.core) {
    callbacks.begin_step("measuring " + id);
    block = make_block(id, scan.mesh, surface, std::move(source), making);
  } else if (options.vertices) {
    callbacks.begin_step("simplifying " + id);
    const TriangleMesh light = simplify_mesh(scan.mesh, {.target_vertices = *options.vertices});
    callbacks.begin_step("measuring " + id);
    source.options += " vertices=" + std::to_string(*options.vertices);
    block = make_block(id, light, surface, std::move(source), making);
  } else {
    callbacks.begin_step("simplifying " + id);
    FewestVerticesSearch search(id, surface, source);
    callbacks.begin_step("fitting " + id);
    block = search.find_block(making, options.radius_given,
                              found.in_deposit ? kDepositRefinement : kScanRefinement);
  }
  if (!block.source.unscaled) check_block_mass(block, options);
  // Simplifying leaves no crossings, but a mesh that is taken as it is may have them.
  const bool as_it_is = block.surface.triangles.size() == scan.mesh.triangles.size();
  if (as_it_is && !options.block.convex) add_self_intersection_warning(block, scan.mesh);
  block.warnings.insert(block.warnings.begin(), scan.notes.begin(), scan.notes.end());
  if (const std::string note = wide_tolerance_note(options.block, block); !note.empty()) {
    block.warnings.insert(block.warnings.begin(), note);
  }
  if (found.bounds && !options.block.convex) add_unseen(block, *found.bounds);
  return block;
}

/// A scan as it was read, whatever it is.
struct ReadScan {
  FieldScan found;
  std::optional<PhotoScan> photos;
  std::optional<JoinedScan> joined = {};
};

FieldScanOptions reading_options(const ScanToBlockOptions& options,
                                 const ScanCallbacks& callbacks) {
  return {.scan = options.scan,
          .up_given = options.up_given,
          .find_ground = options.find_ground,
          .split = options.split,
          .smallest_axis = options.smallest_axis,
          .edits = options.edits,
          .stations = options.stations,
          .surface = {.threads = options.block.threads},
          .progress = callbacks.progress};
}

/// Places the points of joined scans beside their block, as the scan that was read.
ReadScan as_read(JoinedScan joined) {
  ReadScan read;
  read.found.blocks.push_back(std::move(joined.block));
  for (const JoinedPoints& scan : joined.scans) {
    read.found.raw.vertices.insert(read.found.raw.vertices.end(), scan.points.begin(),
                                   scan.points.end());
  }
  read.joined = std::move(joined);
  return read;
}

/// Aligns the passes of a scan. Returns nothing if fewer than two show enough of the block.
std::optional<ReadScan> align_raw_scan(RawScan& raw, const std::string& name,
                                       const ScanToBlockOptions& options, BlockSource& source,
                                       const ScanCallbacks& callbacks) {
  callbacks.begin_step("aligning the passes of " + name);
  std::optional<JoinedScan> aligned = align_passes(
      {name, std::move(raw.mesh), raw.scan}, raw.passes, name, reading_options(options, callbacks),
      {.threads = options.block.threads, .progress = callbacks.progress});
  if (!aligned) {
    if (callbacks.on_note) callbacks.on_note(name + ": no second pass found; nothing was aligned");
    return {};
  }
  std::vector<std::string>& notes = aligned->block.scan.notes;
  notes.insert(notes.end(), raw.notes.begin(), raw.notes.end());
  source.options += " aligned=" + std::to_string(aligned->scans.size());
  return as_read(std::move(*aligned));
}

ScanOptions core_options(const ScanToBlockOptions& options) {
  ScanOptions as_it_is = options.scan;
  as_it_is.repair.fill_missing = false;  // every vertex of a core is meant
  return as_it_is;
}

ReadScan read_any_scan(const std::filesystem::path& path, const ScanToBlockOptions& options,
                       BlockSource& source, const ScanCallbacks& callbacks) {
  const FieldScanOptions reading = reading_options(options, callbacks);
  if (std::filesystem::is_directory(path)) {
    if (options.align) {
      throw InputError(to_utf8(path.string()) +
                       ": photographs are aligned already; leave `align` out");
    }
    PhotographedBlocks made = reconstruct_photographs(path, options, reading, source, callbacks);
    return {std::move(made.field_scan), std::move(made.photos)};
  }
  if (options.align) {
    RawScan raw = read_raw_scan(path, options.scan);
    if (std::optional<ReadScan> aligned =
            align_raw_scan(raw, to_utf8(path.string()), options, source, callbacks)) {
      return std::move(*aligned);
    }
  }
  if (!options.block.core) return {read_field_scan(path, reading), {}};
  FieldScan core;
  core.blocks.push_back({read_scan(path, core_options(options)), {}, {}});
  if (callbacks.on_block_made || options.scale_points) core.raw = read_mesh(path);
  return {std::move(core), {}};
}

/// Digest of the numbers of a mesh in memory.
std::string mesh_digest(const TriangleMesh& mesh) {
  const auto bytes = [](const auto& values) {
    return std::string_view(reinterpret_cast<const char*>(values.data()),
                            values.size() * sizeof(values.front()));
  };
  Sha256 digest;
  digest.add(bytes(mesh.vertices));
  digest.add(bytes(mesh.triangles));
  return digest.finish();
}

ReadScan clean_any_mesh(const TriangleMesh& raw, const std::string& name,
                        const ScanToBlockOptions& options, const ScanCallbacks& callbacks) {
  const FieldScanOptions reading = reading_options(options, callbacks);
  FieldScan found;
  if (options.block.core) {
    found.blocks.push_back({clean_scan(raw, name, core_options(options)), {}, {}});
  } else if (options.split) {
    static_cast<FieldDeposit&>(found) = raw.triangles.empty()
                                            ? extract_deposit_blocks(raw.vertices, name, reading)
                                            : extract_deposit_blocks(raw, name, reading);
  } else if (raw.triangles.empty()) {
    found.blocks = extract_field_blocks(raw.vertices, name, reading);
  } else {
    found.blocks = extract_field_blocks(raw, name, reading);
  }
  found.raw = raw;
  return {std::move(found), {}};
}

/// Describes the parts of a deposit that are not among its blocks: a sum for each reason with the
/// largest parts.
std::vector<std::string> describe_left_out(std::vector<LeftOutPart> parts) {
  constexpr std::size_t kNamed = 5;
  std::stable_sort(parts.begin(), parts.end(),
                   [](const LeftOutPart& a, const LeftOutPart& b) { return a.points > b.points; });
  std::vector<std::string> notes;
  for (const LeftOutReason reason :
       {LeftOutReason::kTooFewPoints, LeftOutReason::kTooSmall, LeftOutReason::kMostlyHidden,
        LeftOutReason::kCutByBorder, LeftOutReason::kUncertain}) {
    std::size_t count = 0;
    std::string places;
    for (const LeftOutPart& part : parts) {
      if (part.reason != reason) continue;
      if (++count <= kNamed) {
        places += (count > 1 ? ", " : "") + format_point(part.centre) + " with " +
                  format_count(part.points, "point");
      }
    }
    if (count == 0) continue;
    notes.push_back(format_count(count, "part") + " left out (" + name_of(reason) + "): " + places +
                    (count > kNamed ? ", ..." : ""));
  }
  return notes;
}

std::vector<Block> make_blocks(ReadScan& read, const std::string& id, BlockSource source,
                               const std::string& up, const ScanToBlockOptions& options,
                               const ScanCallbacks& callbacks) {
  FieldScan& found = read.found;
  if (options.scale_points) note_distant_scale_points(found, *options.scale_points);
  if (options.scan.repair.keep_inner_shells) source.options += " inner_shells=kept";
  if (!options.find_ground) source.options += " ground=none";
  if (!options.edits.empty()) {
    source.options += " edits=" + sha256(format_field(options.edits)).substr(0, 16);
  }
  if (!options.stations.empty()) {
    source.options += " stations=" + sha256(format_field(options.stations)).substr(0, 16);
  }
  if (!options.labelled.empty()) {
    write_labelled_cloud(options.labelled, found.raw.vertices, found.block_of_point);
  }
  if (callbacks.on_note) {
    for (const std::string& note : found.notes) callbacks.on_note(note);
    for (const std::string& note : describe_left_out(found.left_out)) callbacks.on_note(note);
  }
  const std::size_t count = found.blocks.size();
  const auto name_of = [&](std::size_t i) {
    return options.split ? id + "_" + std::to_string(i + 1) : id;
  };
  const auto record_of = [&](const DepositBlock& seen) {
    DepositRecord record{seen.points.size(), seen.spacing, seen.visible_fraction,
                         seen.confidence,    {},           count};
    for (const std::uint32_t other : seen.contacts) record.contacts.push_back(name_of(other));
    return record;
  };
  ScanToBlockOptions one = options;
  if (count > 1) one.block.threads = 1;  // blocks are made in parallel instead
  std::vector<std::optional<Block>> made(count);
  std::vector<std::string> failures(count);
  parallel_for(count, count > 1 ? options.block.threads : 1, [&](std::size_t i) {
    if (options.split && callbacks.is_known && callbacks.is_known(name_of(i))) return;
    try {
      made[i] = make_scan_block(found.blocks[i], name_of(i), source, one, callbacks);
      if (found.blocks[i].in_deposit) made[i]->deposit = record_of(*found.blocks[i].in_deposit);
      if (callbacks.on_block_made) {
        callbacks.on_block_made(*made[i], {.raw = &found.raw,
                                           .field_block = &found.blocks[i],
                                           .photos = read.photos ? &*read.photos : nullptr,
                                           .up = up,
                                           .joined = read.joined ? &*read.joined : nullptr});
      }
    } catch (const Error& error) {  // of several blocks a bad one never costs the others
      if (count == 1 || !callbacks.on_block_lost) throw;
      failures[i] = error.what();
    }
    found.blocks[i] = {};  // memory is bounded by the blocks in work
  });
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < count; ++i) {
    if (made[i]) {
      blocks.push_back(std::move(*made[i]));
    } else if (!failures[i].empty()) {
      callbacks.on_block_lost(name_of(i), failures[i]);
    }
  }
  if (found.spacing > 0.0 && callbacks.on_deposit_made) {
    DepositOrigin origin{&found, read.photos ? 1.0 : options.scan.unit, up, {}};
    for (std::size_t i = 0; i < count; ++i) origin.ids.push_back(name_of(i));
    callbacks.on_deposit_made(blocks, origin);
  }
  return blocks;
}

}  // namespace

std::string compute_scan_digest(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? compute_photo_digest(path) : sha256_of_file(path);
}

void ScanToBlockOptions::check() const {
  scan.check();
  if (vertices) SimplifyOptions{*vertices}.check();
  if (!edits.empty() && !split) throw InputError("`edits` needs `split`");
  if (!stations.empty() && !split) throw InputError("`stations` needs `split`");
  if (!labelled.empty() && !split) throw InputError("`labelled` needs `split`");
  if (align && split) throw InputError("`align` is for one block; leave `split` out");
  if (align && block.core) throw InputError("`align` does not apply to a core");
  block.check();
}

std::vector<Block> reconstruct_blocks(const std::filesystem::path& path, const std::string& id,
                                      const ScanToBlockOptions& options,
                                      const ScanCallbacks& callbacks) {
  callbacks.begin_step("reading " + id);
  const std::string up = resolve_up_axis(options.scan.up, path);
  BlockSource source{to_utf8(path.string()), compute_scan_digest(path),
                     format_scale_record(options) + " up=" + up, ""};
  ReadScan read = read_any_scan(path, options, source, callbacks);
  const std::string read_up = read.joined ? "z" : up;
  return make_blocks(read, id, std::move(source), read_up, options, callbacks);
}

std::string compute_joined_digest(const std::vector<std::filesystem::path>& paths) {
  Sha256 digest;
  for (const std::filesystem::path& path : paths) digest.add(compute_scan_digest(path));
  return digest.finish();
}

Block reconstruct_joined_block(const std::vector<std::filesystem::path>& paths,
                               const std::string& id, const ScanToBlockOptions& options,
                               const ScanCallbacks& callbacks) {
  if (options.split || options.block.core || options.align) {
    throw InputError(std::string("joined scans are of one block each; leave ") +
                     (options.split        ? "`split`"
                      : options.block.core ? "`core`"
                                           : "`align`") +
                     " out");
  }
  std::string names;
  for (const std::filesystem::path& path : paths) {
    names += (names.empty() ? "" : " + ") + to_utf8(path.string());
  }
  BlockSource source{names, compute_joined_digest(paths),
                     format_scale_record(options) + " joined=" + std::to_string(paths.size()), ""};
  ReadScan read = as_read(
      read_joined_scans(paths, id, options, reading_options(options, callbacks), callbacks));
  return make_blocks(read, id, std::move(source), "z", options, callbacks).front();
}

std::vector<Block> reconstruct_mesh_blocks(const TriangleMesh& raw, const std::string& id,
                                           const ScanToBlockOptions& options,
                                           const ScanCallbacks& callbacks) {
  callbacks.begin_step("cleaning " + id);
  const std::string up = options.scan.up == "y" ? "y" : "z";  // no format says otherwise
  BlockSource source{id, mesh_digest(raw), format_scale_record(options) + " up=" + up, ""};
  std::optional<ReadScan> aligned;
  if (options.align) {
    RawScan unknown;
    unknown.mesh = raw;
    unknown.scan = options.scan;
    unknown.scan.up = up;
    aligned = align_raw_scan(unknown, id, options, source, callbacks);
  }
  ReadScan read = aligned ? std::move(*aligned) : clean_any_mesh(raw, id, options, callbacks);
  return make_blocks(read, id, std::move(source), read.joined ? "z" : up, options, callbacks);
}

}  // namespace clast

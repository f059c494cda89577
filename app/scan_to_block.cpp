#include "app/scan_to_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/lightest_block.hpp"
#include "app/text_table.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "library/unscaled.hpp"
#include "library/unseen_range.hpp"
#include "massprops/solid.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/self_intersection.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {

namespace {

constexpr double kLargestBlock = 50.0;   ///< m; longer than any block that was ever scanned whole
constexpr double kSmallestBlock = 1e-3;  ///< m; below it lies sand

/// Photos give points so dense and exact that a finer surface than that of other clouds pays: with
/// the usual cell a sharp end of a block is 0.6 % of L short, with this one 0.14 %.
constexpr double kPhotoCell = 0.003;

/// The unit in which a length of `raw` file units is that of a usual block.
std::string likely_unit(double raw) {
  constexpr std::array<std::pair<const char*, double>, 6> units = {
      {{"m", 1.0}, {"mm", 0.001}, {"cm", 0.01}, {"ft", 0.3048}, {"in", 0.0254}, {"km", 1000.0}}};
  for (const auto& [name, unit] : units) {
    const double length = raw * unit;
    if (length >= 0.05 && length <= 20.0) {
      return std::string("; it is probably in ") + name + ": try --units " + name +
             ", which makes it " + rounded(length, 3) + " m";
    }
  }
  return "";
}

/// The hull in place of the scan, and what that adds to the rock.
TriangleMesh hull_instead(const TriangleMesh& scan, std::vector<std::string>& notes) {
  TriangleMesh hull = convex_hull(scan.vertices);
  const double added =
      solid_mass_properties(hull, 1.0).volume / solid_mass_properties(scan, 1.0).volume - 1.0;
  const Deviation gap = surface_deviation(scan, sphero_polyhedron(hull, 0.0));
  notes.push_back("the convex hull was taken, as asked: it has " + rounded(100.0 * added, 3) +
                  " % more volume than the scan and lies up to " + rounded(gap.hausdorff, 3) +
                  " m off it; distances and moments below are against the hull");
  return hull;
}

/// Adds what the scan leaves open.
void add_unseen(Block& block, const BlockBounds& bounds) {
  const auto axes = [](const Vec3& sides) { return Axes{sides[0], sides[1], sides[2]}; };
  UnseenPart unseen;
  unseen.lower_volume = bounds.lower_volume;
  unseen.best_volume = bounds.best_volume;
  unseen.upper_volume = bounds.upper_volume;
  unseen.invented_share = bounds.invented_share;
  unseen.assumption = bounds.assumption;
  if (bounds.sides) unseen.axes = AxesRange{axes(bounds.sides->lower), axes(bounds.sides->upper)};
  block.unseen = unseen;
  block.warnings.insert(block.warnings.begin(), described_unseen(block));
}

/// Thins and measures one block of a scan.
Block block_from(FieldBlock& found, const std::string& id, BlockSource source,
                 const ScanToBlockOptions& options,
                 const std::function<void(const std::string&)>& begin) {
  Scan& scan = found.scan;
  if (!source.unscaled) check_size(bounds(scan.mesh), id, options);
  if (scan.report.invented_share > 0.0) {
    source.options += " invented_share=" + with_digits(scan.report.invented_share, 4);
  }
  if (options.block.convex) scan.mesh = hull_instead(scan.mesh, scan.notes);
  const ScanSurface surface(scan.mesh);
  Block block;
  if (options.block.core) {
    begin("measuring " + id);
    block = make_block(id, scan.mesh, surface, std::move(source), options.block);
  } else if (options.vertices) {
    begin("thinning " + id);
    const TriangleMesh thin = simplified(scan.mesh, {.target_vertices = *options.vertices});
    begin("measuring " + id);
    source.options += " vertices=" + std::to_string(*options.vertices);
    block = make_block(id, thin, surface, std::move(source), options.block);
  } else {
    begin("thinning " + id);
    LightestBlockSearch search(id, surface, source);
    begin("fitting " + id);
    block = search.lightest(options.block, options.radius_given);
  }
  // Thinning leaves no crossings, but a mesh that is taken as it is may have them.
  const bool as_it_is = block.surface.triangles.size() == scan.mesh.triangles.size();
  if (as_it_is && !options.block.convex) warn_of_crossings(block, scan.mesh);
  block.warnings.insert(block.warnings.begin(), scan.notes.begin(), scan.notes.end());
  if (found.bounds && !options.block.convex) add_unseen(block, *found.bounds);
  return block;
}

/// A point that lies off the scan by more than this share of its diagonal is probably of another.
constexpr double kOffScan = 0.25;

/// Points that gave the scale and lie far from all that was read are told of.
void note_far_scale(FieldScan& found, const std::array<Vec3, 2>& points) {
  if (found.raw.vertices.empty()) return;
  const Bounds box = bounds(found.raw);
  double off = 0.0;
  for (const Vec3& p : points) {
    off = std::max(off, (p - p.cwiseMax(box.low).cwiseMin(box.high)).norm());
  }
  if (off <= kOffScan * box.diagonal()) return;
  for (FieldBlock& block : found.blocks) {
    block.scan.notes.insert(block.scan.notes.begin(),
                            "a point of --scale-length lies " + rounded(off, 3) +
                                " units off this scan, which is " + rounded(box.diagonal(), 3) +
                                " units across: check that both points are of this scan");
  }
}

/// A folder of photos, with what its cameras and its scale were.
struct PhotographedBlocks {
  FieldScan found;
  PhotoScan photos;
};

PhotographedBlocks photographed_blocks(const std::filesystem::path& folder,
                                       const ScanToBlockOptions& options, FieldScanOptions reading,
                                       BlockSource& source,
                                       const std::function<void(const std::string&)>& begin) {
  PhotoScanOptions photos = options.photos;
  if (options.scale_points || reading.scan.unit != 1.0) photos.metres_per_unit = reading.scan.unit;
  PhotoScan scan = photo_scan(folder, photos, begin);
  if (!scan.metric && options.block.mass) {
    throw InputError(folder.string() +
                     ": --mass needs a scale, and these photos have none; give --scale-bar or "
                     "--marker-size");
  }
  reading.scan.unit = 1.0;
  reading.surface.cell = kPhotoCell;
  reading.through = &scan.cloud.through;
  begin("finding the surface in " + std::to_string(scan.cloud.points.size()) + " points");
  FieldScan found;
  try {
    found.blocks = field_blocks(scan.cloud.points, folder.string(), reading);
  } catch (const Error& error) {  // mostly for want of photos, which points don't know
    throw GeometryError(std::string(error.what()) +
                        ". The points come from photos: " + scan.notes.front() +
                        ". Take one every 10 to 15 degrees all round the block, so that each "
                        "shows much of what its neighbours show");
  }
  found.raw.vertices = scan.cloud.points;
  source.options = "photos=" + std::to_string(scan.model.photos.size()) +
                   " cameras=" + scan.model.source + " scale=" + scan.scale_source;
  source.unscaled = !scan.metric;
  for (FieldBlock& block : found.blocks) {
    std::vector<std::string>& notes = block.scan.notes;
    notes.insert(notes.begin(), scan.notes.begin(), scan.notes.end());
    if (!scan.metric) {
      notes.insert(notes.begin(), "UNSCALED, and where notes say m they mean units of the model: " +
                                      unscaled_reason());
    }
  }
  return {std::move(found), std::move(scan)};
}

}  // namespace

std::string digest_of_scan(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? photo_set_digest(path) : sha256_of_file(path);
}

void check_size(const Bounds& box, const std::string& id, const ScanToBlockOptions& options) {
  const double length = (box.high - box.low).maxCoeff();
  if (options.any_size || (length <= kLargestBlock && length >= kSmallestBlock)) return;
  const std::string size = "block " + id + " would be " + rounded(length, 3) + " m long, ";
  const std::string anyway = "; --any-size takes it as it is";
  if (options.scale_points) {
    throw InputError(size + "scaled by --scale-length: check its two points and its metres" +
                     anyway);
  }
  throw InputError(size + "read with --units " + options.unit_name +
                   likely_unit(length * options.scale_factor / options.scan.unit) + anyway);
}

std::string scale_text(const ScanToBlockOptions& options) {
  std::string text = "units=" + options.unit_name;
  if (options.scale_points) {
    text = "unit_by_length_m=" + with_digits(options.scan.unit / options.scale_factor, 9);
  }
  if (options.scale_factor != 1.0) {
    text += " scale_factor=" + with_digits(options.scale_factor, 9);
  }
  return text;
}

void warn_of_crossings(Block& block, const TriangleMesh& surface) {
  const std::size_t pairs = crossing_triangles(surface).size();
  if (pairs == 0) return;
  block.warnings.push_back("the surface passes through itself at " + std::to_string(pairs) +
                           (pairs == 1 ? " pair" : " pairs") +
                           " of triangles: what lies inside twice counts twice in its volume; mend "
                           "it in MeshLab or CloudCompare");
}

void ScanToBlockOptions::check() const {
  scan.check();
  if (vertices) SimplifyOptions{*vertices}.check();
  block.check();
}

std::vector<Block> blocks_from_scan(const std::filesystem::path& path, const std::string& id,
                                    const ScanToBlockOptions& options,
                                    const std::function<void(const std::string&)>& stage,
                                    const BlockWitness& witness, const BlockLoss& lost) {
  const auto begin = [&](const std::string& what) {
    if (stage) stage(what);
  };
  begin("reading " + id);
  FieldScan found;
  std::optional<PhotoScan> photos;
  BlockSource source{as_utf8(path.string()), digest_of_scan(path),
                     scale_text(options) + " up=" + options.scan.up, ""};
  const FieldScanOptions reading_field = {.scan = options.scan,
                                          .up_given = options.up_given,
                                          .find_ground = options.find_ground,
                                          .split = options.split};
  if (std::filesystem::is_directory(path)) {
    PhotographedBlocks made = photographed_blocks(path, options, reading_field, source, begin);
    found = std::move(made.found);
    photos = std::move(made.photos);
  } else if (options.block.core) {
    ScanOptions reading = options.scan;
    reading.repair.invent = false;  // every vertex of a core is meant
    found.blocks.push_back({read_scan(path, reading), {}, {}});
    if (witness || options.scale_points) found.raw = read_mesh(path);
  } else {
    found = read_field_scan(path, reading_field);
  }
  if (options.scale_points) note_far_scale(found, *options.scale_points);
  if (options.scan.repair.keep_inner_shells) source.options += " inner_shells=kept";
  if (!options.find_ground) source.options += " ground=none";
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < found.blocks.size(); ++i) {
    const std::string name = options.split ? id + "_" + std::to_string(i + 1) : id;
    try {
      blocks.push_back(block_from(found.blocks[i], name, source, options, begin));
    } catch (const Error& error) {  // of several blocks a bad one never costs the others
      if (found.blocks.size() == 1 || !lost) throw;
      lost(name, error.what());
      found.blocks[i] = {};
      continue;
    }
    if (witness) {
      witness(blocks.back(), found.raw, found.blocks[i], photos ? &*photos : nullptr);
    }
    found.blocks[i] = {};  // memory is bounded by one block's needs
  }
  return blocks;
}

}  // namespace clast

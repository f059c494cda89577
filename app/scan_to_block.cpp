#include "app/scan_to_block.hpp"

#include <array>
#include <iterator>
#include <utility>

#include "app/text_table.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "shapes/self_intersection.hpp"

namespace clast {

namespace {

constexpr double kLargestBlock = 50.0;   ///< m; longer than any block that was ever scanned whole
constexpr double kSmallestBlock = 1e-3;  ///< m; below it lies sand

/// Tried in turn. More vertices than the last make a simulation slow for little.
constexpr std::array<std::size_t, 7> kVertexCounts = {250, 350, 500, 700, 1000, 1400, 2000};
/// A corner of a cube loses 0.73 radii, one of a tetrahedron 2: 0.0025 of S keeps even that.
constexpr int kRadiusHalvings = 3;

/// The unit in which a length of `raw` file units is that of a usual block.
std::string likely_unit(double raw) {
  constexpr std::array<std::pair<const char*, double>, 6> units = {
      {{"m", 1.0}, {"mm", 0.001}, {"cm", 0.01}, {"ft", 0.3048}, {"in", 0.0254}, {"km", 1000.0}}};
  for (const auto& [name, unit] : units) {
    const double length = raw * unit;
    if (length >= 0.05 && length <= 20.0) {
      return std::string("; --units ") + name + " would make it " + rounded(length, 3) + " m";
    }
  }
  return "";
}

/// Every trial starts from the largest count, so that a large scan is thinned once. A scan that
/// can't be thinned to that one may still lose its flaws on the way to a smaller one.
TriangleMesh thinned_for_trials(const TriangleMesh& scan) {
  try {
    return simplified(scan, {.target_vertices = std::end(kVertexCounts)[-1]});
  } catch (const GeometryError&) {
    return scan;
  }
}

/// The block within the tolerance that has the fewest vertices and, for these, the largest radius;
/// where there is none, the first that could be made.
Block lightest_block(const std::string& id, const TriangleMesh& fine, const TriangleMesh& scan,
                     const BlockSource& source, const ScanToBlockOptions& options) {
  const double tolerance = options.block.tolerance * smallest_box(scan.vertices).lengths[0];
  std::optional<Block> first;
  std::string refusal;
  for (const std::size_t count : kVertexCounts) {
    try {
      const TriangleMesh surface = simplified(fine, {.target_vertices = count});
      BlockSource counted = source;
      counted.options += " vertices=" + std::to_string(count);
      const bool near =
          surface_deviation(scan, sphero_polyhedron(surface, 0.0)).hausdorff <= tolerance;
      BlockOptions trial = options.block;
      for (int halving = 0; near || !first; ++halving) {
        Block block = make_block(id, surface, scan, counted, trial);
        if (within_tolerance(block, trial)) return block;
        if (!first) first = std::move(block);
        if (!near || options.radius_given || halving == kRadiusHalvings) break;
        trial.radius_share /= 2.0;
      }
    } catch (const GeometryError& error) {
      if (refusal.empty()) refusal = error.what();
    }
    if (fine.vertices.size() <= count) break;  // more would change nothing
  }
  if (!first) throw GeometryError(refusal);
  first->warnings.push_back("no block of up to " + std::to_string(std::end(kVertexCounts)[-1]) +
                            " vertices is nearer than the tolerance to this scan; this is the "
                            "lightest");
  return std::move(*first);
}

}  // namespace

void check_size(const Bounds& box, const std::string& id, const ScanToBlockOptions& options) {
  const double length = (box.high - box.low).maxCoeff();
  if (options.any_size || (length <= kLargestBlock && length >= kSmallestBlock)) return;
  throw InputError("block " + id + " would be " + rounded(length, 3) +
                   " m long, read with --units " + options.unit_name +
                   likely_unit(length / options.scan.unit) + "; --any-size takes it as it is");
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

Block block_from_scan(const std::filesystem::path& path, const std::string& id,
                      const ScanToBlockOptions& options,
                      const std::function<void(const std::string&)>& stage) {
  const auto begin = [&](const std::string& what) {
    if (stage) stage(what + " " + id);
  };
  begin("reading");
  const Scan scan = read_scan(path, options.scan);
  check_size(bounds(scan.mesh), id, options);
  BlockSource source{path.string(), sha256_of_file(path),
                     "units=" + options.unit_name + " up=" + options.scan.up, ""};
  if (options.scan.keep_inner_shells) source.options += " inner_shells=kept";
  Block block;
  if (options.block.core) {
    begin("measuring");
    block = make_block(id, scan.mesh, scan.mesh, std::move(source), options.block);
  } else if (options.vertices) {
    begin("thinning");
    const TriangleMesh surface = simplified(scan.mesh, {.target_vertices = *options.vertices});
    begin("measuring");
    source.options += " vertices=" + std::to_string(*options.vertices);
    block = make_block(id, surface, scan.mesh, std::move(source), options.block);
  } else {
    begin("thinning");
    const TriangleMesh fine = thinned_for_trials(scan.mesh);
    begin("measuring");
    block = lightest_block(id, fine, scan.mesh, source, options);
  }
  // Thinning leaves no crossings, but a mesh that is taken as it is may have them.
  const bool as_it_is = block.surface.triangles.size() == scan.mesh.triangles.size();
  if (as_it_is) warn_of_crossings(block, scan.mesh);
  block.warnings.insert(block.warnings.begin(), scan.notes.begin(), scan.notes.end());
  return block;
}

}  // namespace clast

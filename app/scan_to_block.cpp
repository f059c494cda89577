#include "app/scan_to_block.hpp"

#include <array>
#include <utility>

#include "app/text_table.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"

namespace clast {

namespace {

constexpr double kLargestBlock = 50.0;   ///< m; longer than any block that was ever scanned whole
constexpr double kSmallestBlock = 1e-3;  ///< m; below it lies sand

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

void check_size(const TriangleMesh& mesh, const std::string& id,
                const ScanToBlockOptions& options) {
  const Bounds box = bounds(mesh);
  const double length = (box.high - box.low).maxCoeff();
  if (options.any_size || (length <= kLargestBlock && length >= kSmallestBlock)) return;
  throw InputError("block " + id + " would be " + rounded(length, 3) +
                   " m long, read with --units " + options.unit_name +
                   likely_unit(length / options.scan.unit) + "; --any-size takes it as it is");
}

}  // namespace

void ScanToBlockOptions::check() const {
  scan.check();
  simplify.check();
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
  check_size(scan.mesh, id, options);
  BlockSource source{path.string(), sha256_of_file(path),
                     "units=" + options.unit_name + " up=" + options.scan.up, ""};
  TriangleMesh surface = scan.mesh;
  if (!options.block.core) {
    begin("thinning");
    surface = simplified(scan.mesh, options.simplify);
    source.options += " vertices=" + std::to_string(options.simplify.target_vertices);
  }
  begin("measuring");
  Block block = make_block(id, surface, scan.mesh, std::move(source), options.block);
  block.warnings.insert(block.warnings.begin(), scan.notes.begin(), scan.notes.end());
  return block;
}

}  // namespace clast

#include "pipeline/detail/scan_scale.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "library/block_ranges.hpp"

namespace clast::pipeline_detail {

namespace {

/// A point that lies off the scan by more than this share of its diagonal is probably of another.
constexpr double kOffScan = 0.25;

/// The unit in which a length of `raw` file units is that of a usual block.
std::string likely_unit(double raw) {
  for (const char* name : {"m", "mm", "cm", "ft", "in", "km"}) {
    const double length = raw * parse_length_unit(name);
    if (length >= 0.05 && length <= kMaxUsualLength) {
      return std::string("; it is probably in ") + name + ": try `units` " + name +
             ", which makes it " + format_rounded(length, 3) + " m";
    }
  }
  return "";
}

}  // namespace

void check_scan_size(const Bounds& box, const std::string& id, const ScanToBlockOptions& options) {
  const double length = (box.high - box.low).maxCoeff();
  if (options.allow_any_size || (length <= kMaxUsualLength && length >= kMinUsualLength)) return;
  const std::string size = "block " + id + " would be " + format_rounded(length, 3) + " m long, ";
  const std::string anyway = "; `any_size` accepts it";
  if (options.scale_points) {
    throw InputError(size + "scaled by `scale_points`: check its two points and its length" +
                     anyway);
  }
  throw InputError(size + "read with `units` " + options.units +
                   likely_unit(length * options.scale_factor / options.scan.unit) + anyway);
}

void check_block_mass(const Block& block, const ScanToBlockOptions& options) {
  if (options.allow_any_size || block.mass.mass <= kMaxUsualMass) return;
  throw InputError("block " + block.id + " would be " +
                   format_significant(block.mass.mass / 1000.0, 4) +
                   " t heavy, but blocks are rarely heavier than " +
                   format_significant(kMaxUsualMass / 1000.0, 5) +
                   " t: check scale and density; `any_size` accepts it");
}

std::string format_scale_record(const ScanToBlockOptions& options) {
  std::string text = "units=" + options.units;
  if (options.scale_points) {
    text = "unit_by_length_m=" + format_significant(options.scan.unit / options.scale_factor, 9);
  }
  if (options.scale_factor != 1.0) {
    text += " scale_factor=" + format_significant(options.scale_factor, 9);
  }
  return text;
}

void note_distant_scale_points(FieldScan& found, const std::array<Vec3, 2>& points) {
  if (found.raw.vertices.empty()) return;
  const Bounds box = bounds(found.raw);
  double off = 0.0;
  for (const Vec3& p : points) {
    off = std::max(off, (p - p.cwiseMax(box.low).cwiseMin(box.high)).norm());
  }
  if (off <= kOffScan * box.diagonal()) return;
  for (FieldBlock& block : found.blocks) {
    block.scan.notes.insert(block.scan.notes.begin(),
                            "a point of `scale_points` lies " + format_rounded(off, 3) +
                                " units off this scan, which is " +
                                format_rounded(box.diagonal(), 3) +
                                " units across: check that both points are of this scan");
  }
}

}  // namespace clast::pipeline_detail

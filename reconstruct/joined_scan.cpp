#include "reconstruct/joined_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "reconstruct/detail/block_points.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/registration/joined_surface.hpp"

namespace clast {

namespace {

using namespace reconstruct_detail;

std::string describe_fit(const Registration& fit, const std::vector<ScanToJoin>& scans) {
  std::string text = "joined from " + std::to_string(scans.size()) + " scans";
  for (std::size_t s = 0; s < scans.size(); ++s) text += (s == 0 ? ": " : ", ") + scans[s].name;
  text += "; each overlaps the others by " + format_significant(100.0 * fit.overlap, 2) +
          " % or more, and their surfaces lie " + format_significant(fit.deviation, 2) +
          " m apart (root mean square; standard deviation of the points " +
          format_significant(fit.noise, 2) + " m)";
  if (fit.disagreeing_fraction > 0.0) {
    text += "; they disagree by " + format_significant(fit.disagreement, 2) + " m over " +
            format_significant(100.0 * fit.disagreeing_fraction, 2) + " % of the overlap";
  }
  return text;
}

}  // namespace

JoinedScan join_scans(const std::vector<ScanToJoin>& scans, const std::string& name,
                      const FieldScanOptions& options, const RegistrationOptions& registration) {
  std::vector<ScanToRegister> to_register;
  std::vector<std::string> notes;
  for (const ScanToJoin& scan : scans) {
    FieldScanOptions own = options;
    own.scan = scan.scan;
    BlockPoints block = extract_block_points(scan.raw, scan.name, own);
    for (const std::string& note : block.notes) notes.push_back(scan.name + ": " + note);
    to_register.push_back({scan.name, std::move(block.points), block.ground, scan.free_scale});
  }
  JoinedScan joined;
  joined.registration =
      with_error_context(name, [&] { return register_scans(to_register, registration); });
  const Registration& fit = joined.registration;
  JoinedSurface surface =
      with_error_context(name, [&] { return join_surfaces(to_register, fit, options.surface); });
  notes.insert(notes.begin(), describe_fit(fit, scans));
  notes.insert(notes.end(), fit.notes.begin(), fit.notes.end());
  notes.insert(notes.end(), surface.notes.begin(), surface.notes.end());
  FieldScanOptions closing = options;
  closing.scan.unit = 1.0;
  closing.scan.up = "z";
  joined.block = close_block({.surface = std::move(surface.cloud.mesh),
                              .uncertainty = &surface.cloud.uncertainty,
                              .notes = std::move(notes)},
                             name, closing);
  joined.scans = std::move(surface.scans);
  return joined;
}

}  // namespace clast

#include "reconstruct/scan.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "reconstruct/detail/stored_digits.hpp"

namespace clast {

void ScanOptions::check() const {
  if (!(unit > 0.0) || !std::isfinite(unit)) {
    throw InputError("unit = " + format_significant(unit, 6) +
                     ": metres per unit of the file must be positive, for example 0.001 for mm");
  }
  resolve_up_axis(up, {});
  repair.check();
}

ScanOptions resolve_scan_options(const std::filesystem::path& file, ScanOptions options) {
  options.up = resolve_up_axis(options.up, file);
  return options;
}

Scan read_scan(const std::filesystem::path& path, const ScanOptions& options) {
  options.check();
  const TriangleMesh raw = read_mesh(path);
  const std::string note = reconstruct_detail::check_coordinate_digits(raw, path, options.unit);
  Scan scan = clean_scan(raw, path.string(), resolve_scan_options(path, options));
  if (!note.empty()) scan.notes.push_back(note);
  return scan;
}

Scan clean_scan(const TriangleMesh& raw, const std::string& name, const ScanOptions& options,
                const std::optional<Pose>& upright_pose) {
  options.check();
  const bool y_up = options.up == "y";
  TriangleMesh mesh = raw;
  for (Vec3& vertex : mesh.vertices) {
    vertex *= options.unit;
    if (y_up) vertex = y_up_to_z_up(vertex);
    if (upright_pose) vertex = *upright_pose * vertex;
  }
  RepairOptions repair = options.repair;
  repair.to_reported_position = [&](const Vec3& there) -> Vec3 {
    const Vec3 metres = upright_pose ? upright_pose->inverse() * there : there;
    return (y_up ? z_up_to_y_up(metres) : metres) / options.unit;
  };
  return with_error_context(name, [&]() -> Scan {
    RepairedMesh result = repair_mesh(mesh, repair);
    std::vector<std::string> notes = describe_repairs(result.report);
    return {std::move(result.mesh), std::move(result.report), std::move(notes)};
  });
}

}  // namespace clast

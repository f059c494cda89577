#include "reconstruct/scan.hpp"

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"
#include "reconstruct/detail/stored_digits.hpp"
#include "shapes/mesh_io.hpp"

namespace clast {

namespace {

/// Step of the coordinates over the diagonal above which the shape is lost, and above which it is
/// worth a note.
constexpr double kShapeLost = 1e-2, kDigitsLost = 1e-4;
/// So many vertices of a text file that all fall on the steps are no chance and no handmade model.
constexpr std::size_t kNoChance = 100;

/// The note on a file that keeps too few digits, empty where there are enough.
/// @throws InputError  the shape of the block is lost
std::string digits_note(const TriangleMesh& mesh, const std::filesystem::path& path, double unit) {
  const std::string extension = extension_of(path);
  const bool keeps_floats =
      extension == ".stl" || extension == ".glb" || extension == ".gltf" || extension == ".3ds";
  if (!keeps_floats && mesh.vertices.size() < kNoChance) return "";
  const std::optional<detail::CoordinateStep> found = detail::coordinate_step(mesh);
  if (!found) return "";
  const double diagonal = bounds(mesh).diagonal();
  const double share = found->step / diagonal;
  if (!(share > kDigitsLost)) return "";
  const std::string text = "precision was lost in the file itself: its coordinates reach " +
                           with_digits(found->largest, 9) + " and are kept in steps of " +
                           with_digits(found->step * unit, 3) + " m, " +
                           with_digits(100.0 * share, 3) + " % of the scan's diagonal of " +
                           with_digits(diagonal * unit, 3) + " m";
  const std::string advice =
      "; export it again with a local origin (CloudCompare: accept the global shift when loading) "
      "or as PLY with doubles";
  if (share <= kShapeLost) return text + advice;
  throw InputError(path.string() + ": " + text + ", so that its shape is lost" + advice);
}

}  // namespace

void ScanOptions::check() const {
  if (!(unit > 0.0) || !std::isfinite(unit)) {
    throw InputError("unit = " + std::to_string(unit) +
                     ": metres per unit of the file must be positive, for example 0.001 for mm");
  }
  if (up != "y" && up != "z") throw InputError("up = \"" + up + "\": must be \"y\" or \"z\"");
  repair.check();
}

Scan read_scan(const std::filesystem::path& path, const ScanOptions& options) {
  options.check();
  const TriangleMesh raw = read_mesh(path);
  const std::string note = digits_note(raw, path, options.unit);
  Scan scan = cleaned_scan(raw, path.string(), options);
  if (!note.empty()) scan.notes.push_back(note);
  return scan;
}

Scan cleaned_scan(const TriangleMesh& raw, const std::string& name, const ScanOptions& options) {
  options.check();
  const bool y_up = options.up == "y";
  TriangleMesh mesh = raw;
  for (Vec3& vertex : mesh.vertices) {
    vertex *= options.unit;
    if (y_up) vertex = Vec3(vertex.x(), -vertex.z(), vertex.y());
  }
  RepairOptions repair = options.repair;
  repair.place_told = [&](const Vec3& there) -> Vec3 {
    return (y_up ? Vec3(there.x(), there.z(), -there.y()) : there) / options.unit;
  };
  try {
    Repaired result = repaired(mesh, repair);
    std::vector<std::string> notes = repair_notes(result.report);
    return {std::move(result.mesh), std::move(result.report), std::move(notes)};
  } catch (const GeometryError& error) {
    throw GeometryError(name + ": " + error.what());
  }
}

}  // namespace clast

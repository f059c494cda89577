#include "pipeline/shape_to_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/digest.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "pipeline/detail/crossing_warning.hpp"
#include "pipeline/detail/scan_scale.hpp"
#include "shapes/coplanar_faces.hpp"

namespace clast {

using namespace pipeline_detail;

namespace {

/// Radii that differ by less are the same number written twice.
constexpr double kSameRadius = 1e-6;
/// Standard errors that a sampled number may be off.
constexpr double kStandardErrors = 2.0;
/// Relative difference below which nothing is said however many points were sampled.
constexpr double kRounding = 1e-5;

double radius_of(const ShpShape& shape, const ScanToBlockOptions& options) {
  const double radius = shape.body.radius * options.scan.unit;
  const std::optional<double>& asked = options.block.radius;
  if (asked && std::abs(*asked - radius) > kSameRadius * std::max(*asked, radius)) {
    throw InputError("`radius` " + format_significant(*asked, 5) +
                     " m contradicts the radius of the shape, " + format_significant(radius, 5) +
                     " m; leave `radius` out");
  }
  return radius;
}

/// Relative standard errors of volume and moments counted from n random points in a box of which
/// the body fills a share f: (1 - f) / (f n) is the variance of the volume; that of a moment over
/// that volume is larger by that of the arms squared, whose mean square is at most about twice
/// their mean squared in compact bodies. The box was along the axes of some scan and not the
/// smallest; half the share of the smallest is taken.
std::pair<double, double> sampling_errors(const Block& block, double points) {
  const double f = 0.5 * std::min(1.0, block.mass.volume / block.box.volume());
  return {std::sqrt((1.0 - f) / (f * points)), std::sqrt((3.0 - 2.0 * f) / (f * points))};
}

void warn_of_gap(Block& block, const std::string& what, double gap, double error) {
  if (gap <= std::max(kStandardErrors * error, kRounding)) return;
  block.warnings.push_back("the .shp file gives " + what + ": " +
                           format_significant(100.0 * gap, 3) +
                           " % apart, of which sampling explains " +
                           format_significant(100.0 * kStandardErrors * error, 2) +
                           " %; the value computed from the shape is used");
}

std::string numbers(const Vec3& v) {
  return format_significant(v.x(), 5) + " " + format_significant(v.y(), 5) + " " +
         format_significant(v.z(), 5);
}

void compare_with_file(Block& block, const ShpShape& shape, double unit) {
  const auto [volume_error, moment_error] = sampling_errors(block, shape.sampled_points);
  if (shape.volume != 0.0) {
    const double file = shape.volume * unit * unit * unit;
    warn_of_gap(block,
                "a volume of " + format_significant(file, 5) + " m3, its shape has " +
                    format_significant(block.mass.volume, 5),
                std::abs(file / block.mass.volume - 1.0), volume_error);
  }
  if (shape.inertia_per_mass.isZero()) return;
  Vec3 file = shape.inertia_per_mass * unit * unit;
  std::sort(file.data(), file.data() + 3);
  const Vec3 ours = block.principal.moments / block.mass.mass;
  warn_of_gap(block, "I/m of " + numbers(file) + " m2, its shape has " + numbers(ours),
              (file - ours).cwiseQuotient(ours).cwiseAbs().maxCoeff(), moment_error);
}

/// A ball or a capsule: nothing to repair.
Block block_from_skeleton(const ShpShape& shape, double radius, const std::string& id,
                          BlockSource source, const ScanToBlockOptions& options) {
  SpheroPolyhedron body = shape.body;
  body.radius = radius;
  for (Vec3& vertex : body.vertices) {
    vertex *= options.scan.unit;
    if (options.scan.up == "y") vertex = y_up_to_z_up(vertex);
  }
  const bool capsule = body.vertices.size() == 2 && body.edges.size() == 1;
  if (body.vertices.size() != 1 && !capsule) {
    throw GeometryError("a shape of " + std::to_string(body.vertices.size()) + " vertices, " +
                        std::to_string(body.edges.size()) +
                        " edges and no faces; without faces clast takes one vertex (a ball) or "
                        "two and their edge (a capsule)");
  }
  return make_block(id, body, std::move(source), options.block);
}

}  // namespace

Block make_shape_block(const ShpShape& shape, const std::filesystem::path& path,
                       const std::string& id, const ScanToBlockOptions& options,
                       const ScanCallbacks& callbacks) {
  const std::string where = path.string() + ": shape " + shape.name;
  const auto in_shape = [&](const std::string& message) {
    return message.find(path.string()) == std::string::npos ? where + ": " + message : message;
  };
  return with_rewritten_error(in_shape, [&] {
    if (shape.is_surface) {
      throw InputError(
          "is a surface (isSurface), not a block; give ground as a mesh to clast terrain");
    }
    callbacks.begin_step("measuring " + id);
    ScanToBlockOptions taken = options;
    taken.block.core = true;
    taken.block.radius = radius_of(shape, options);
    taken.scan.repair.fill_missing = false;
    BlockSource source{to_utf8(path.string()), sha256_of_file(path),
                       format_scale_record(options) +
                           " up=" + resolve_up_axis(options.scan.up, path) + " shape=" + shape.name,
                       ""};
    Block block;
    if (shape.body.faces.empty()) {
      block = block_from_skeleton(shape, *taken.block.radius, id, std::move(source), taken);
    } else {
      const Scan scan = clean_scan(core_mesh(shape.body), where, taken.scan);
      const SpheroPolyhedron body = make_sphero_polyhedron(scan.mesh, *taken.block.radius);
      block = make_block(id, merge_coplanar_faces(body, kFileFlatnessTolerance), std::move(source),
                         taken.block);
      add_self_intersection_warning(block, scan.mesh);
      block.warnings.insert(block.warnings.begin(), scan.notes.begin(), scan.notes.end());
    }
    check_scan_size(bounds(block.surface), id, options);
    check_block_mass(block, options);
    block.warnings.insert(block.warnings.begin(), shape.notes.begin(), shape.notes.end());
    compare_with_file(block, shape, options.scan.unit);
    if (callbacks.on_block_made) callbacks.on_block_made(block, {});
    return block;
  });
}

}  // namespace clast

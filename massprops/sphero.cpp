#include "massprops/sphero.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "massprops/column_quadrature.hpp"
#include "massprops/moments.hpp"
#include "massprops/offset_layer.hpp"
#include "massprops/principal_frame.hpp"

namespace clast {

using namespace massprops_detail;

namespace {

constexpr std::size_t kFirstGrid = 64;
constexpr std::size_t kLastGrid = 4096;
// The error of columns falls about with this power of their number per side.
constexpr double kOrder = 1.75;
// A closed convex surface turns through 4 pi in all; this is the rounding of the sum.
constexpr double kTurning = 1e-9;
// Step of the radius for the area, as a share of it, and the accuracy required of the result.
constexpr double kAreaStep = 0.05;
constexpr double kAreaAccuracy = 1e-3;

void check_radius(double radius) {
  if (radius >= 0.0 && std::isfinite(radius)) return;
  throw InputError("Minkowski radius " + format_significant(radius, 6) +
                   " m: must be finite and not negative");
}

/// Ball or capsule, by pieces: the core has no faces.
MassProperties ball_or_capsule(const SpheroPolyhedron& body, double density) {
  const double r = body.radius;
  const bool ball = body.vertices.size() == 1 && body.edges.empty();
  const bool capsule = body.vertices.size() == 2 && body.edges.size() == 1;
  if (!ball && !capsule) {
    throw GeometryError("core of " + std::to_string(body.vertices.size()) + " vertices and " +
                        std::to_string(body.edges.size()) +
                        " edges has no faces, so it bounds no solid; give its faces");
  }
  if (!(r > 0.0)) throw GeometryError("a core without faces needs a radius above zero");
  const Vec3 p = body.vertices.front();
  const Vec3 q = body.vertices.back();
  const Vec3 middle = 0.5 * (p + q);
  const Vec3 half = 0.5 * (q - p);
  const double length = 2.0 * half.norm();
  const double ball_volume = 4.0 / 3.0 * kPi * r * r * r;
  const double tube_volume = kPi * r * r * length;
  SolidMoments moments;
  moments.volume = ball_volume + tube_volume;
  // Two half balls about the ends, each with its own first moment (3/8 r outward), and the tube.
  moments.second = (ball_volume * r * r / 5.0) * Mat3::Identity();
  if (length > 0.0) {
    const Vec3 t = 2.0 * half / length;
    const Mat3 along = t * t.transpose();
    moments.second +=
        ball_volume * (0.25 * length * length + 0.375 * r * length) * along +
        tube_volume * (length * length / 12.0 * along + 0.25 * r * r * (Mat3::Identity() - along));
  }
  return to_mass_properties(moments, middle, Mat3::Identity(), density);
}

/// The core about its own middle, along turned axes.
struct LocalCore {
  TriangleMesh mesh;
  Vec3 origin;
  Mat3 rotation = Mat3::Identity();  ///< source_from_local
  SolidMoments moments;
};

LocalCore local_core(const SpheroPolyhedron& body) {
  check_radius(body.radius);
  LocalCore core;
  core.mesh = core_mesh(body);
  check_closed(core.mesh, "core");
  core.origin = vertex_mean(core.mesh);
  for (Vec3& vertex : core.mesh.vertices) vertex -= core.origin;
  core.moments = polyhedron_moments(core.mesh, Vec3::Zero());
  if (core.moments.volume > 0.0) {  // about its own centre, whatever the spacing of its vertices
    const Vec3 centre = core.moments.first / core.moments.volume;
    core.origin += centre;
    for (Vec3& vertex : core.mesh.vertices) vertex -= centre;
    core.moments = polyhedron_moments(core.mesh, Vec3::Zero());
  }
  if (!(core.moments.volume > 0.0)) {
    throw GeometryError("core encloses " + format_significant(core.moments.volume, 6) +
                        " m3: its faces point inward or it is flat; turn them outward first");
  }
  return core;
}

bool is_convex(const OffsetLayer& skin) {
  return !skin.has_reflex_edge && std::abs(skin.solid_angle - 4.0 * kPi) < kTurning;
}

MassProperties exact_sum(const LocalCore& core, const OffsetLayer& skin, double density) {
  SolidMoments sum = core.moments;
  sum += skin.piece_moments;
  return to_mass_properties(sum, core.origin, core.rotation, density);
}

/// Turned so that no face, edge or symmetry plane of a man-made core is parallel to the columns,
/// where thousands of them would err the same way.
LocalCore turned(LocalCore core) {
  const Quat oblique = Quat(0.8731, 0.2917, -0.1843, 0.3449).normalized();
  const Mat3 local_from_core = oblique.toRotationMatrix();
  for (Vec3& vertex : core.mesh.vertices) vertex = (local_from_core * vertex).eval();
  core.rotation = local_from_core.transpose();
  core.moments = polyhedron_moments(core.mesh, Vec3::Zero());
  return core;
}

/// Columns per side that should bring the error down by `factor`.
std::size_t next_grid(std::size_t columns_per_side, double factor) {
  const double growth = std::clamp(1.05 * std::pow(factor, 1.0 / kOrder), 1.25, 8.0);
  const double wanted = std::ceil(growth * static_cast<double>(columns_per_side));
  return std::min(static_cast<std::size_t>(wanted), kLastGrid);
}

MassProperties less_excess(const LocalCore& core, const OffsetLayer& skin,
                           const OverlapIntegral& excess, double density) {
  SolidMoments sum = core.moments;
  sum += skin.piece_moments;
  sum.add_scaled(skin.overlap_moments, -1.0);
  sum.add_scaled(excess.moments, -1.0);
  MassProperties result = to_mass_properties(sum, core.origin, core.rotation, density);
  const double smallest_moment = principal_frame(result).moments[0] / density;
  result.relative_error =
      std::max(excess.volume_error / result.volume, excess.second_moment_error / smallest_moment);
  return result;
}

}  // namespace

MassProperties convex_sphero_mass_properties(const SpheroPolyhedron& body, double density) {
  check_density(density);
  check_radius(body.radius);
  if (body.faces.empty()) return ball_or_capsule(body, density);
  const LocalCore core = local_core(body);
  const OffsetLayer skin = decompose_offset_layer(core.mesh, body.radius, body.radius);
  if (!is_convex(skin)) {
    throw GeometryError("core is not convex: it has a reflex edge, or more than one component");
  }
  return exact_sum(core, skin, density);
}

MassProperties sphero_mass_properties(const SpheroPolyhedron& body, double density,
                                      double accuracy) {
  check_density(density);
  check_radius(body.radius);
  if (!(accuracy >= 1e-9 && accuracy <= 0.1)) {
    throw InputError("accuracy " + format_significant(accuracy, 6) + ": must be from 1e-9 to 0.1");
  }
  if (body.faces.empty()) return ball_or_capsule(body, density);
  const LocalCore core = local_core(body);
  const OffsetLayer skin = decompose_offset_layer(core.mesh, body.radius, body.radius);
  if (is_convex(skin)) return exact_sum(core, skin, density);

  const LocalCore oblique = turned(core);
  const OffsetLayer oblique_skin = decompose_offset_layer(oblique.mesh, body.radius, body.radius);
  const ColumnQuadrature columns(oblique.mesh, oblique_skin);
  MassProperties result;
  for (std::size_t columns_per_side = kFirstGrid;;
       columns_per_side = next_grid(columns_per_side, result.relative_error / accuracy)) {
    result =
        less_excess(oblique, oblique_skin, columns.integrate_overlap(columns_per_side), density);
    if (result.relative_error <= accuracy || columns_per_side >= kLastGrid) return result;
  }
}

double sphero_surface_area(const SpheroPolyhedron& body) {
  check_radius(body.radius);
  const double r = body.radius;
  if (body.faces.empty()) {
    ball_or_capsule(body, 1.0);  // refuses what is neither ball nor capsule
    const double length = (body.vertices.back() - body.vertices.front()).norm();
    return 4.0 * kPi * r * r + 2.0 * kPi * r * length;
  }
  const LocalCore core = turned(local_core(body));
  const OffsetLayer skin = decompose_offset_layer(core.mesh, r, (1.0 + kAreaStep) * r);
  if (is_convex(skin) || r == 0.0) return skin.area;

  const OffsetLayer wider =
      decompose_offset_layer(core.mesh, (1.0 + kAreaStep) * r, (1.0 + kAreaStep) * r);
  const OffsetLayer narrower =
      decompose_offset_layer(core.mesh, (1.0 - kAreaStep) * r, (1.0 + kAreaStep) * r);
  const ColumnQuadrature outer(core.mesh, wider);
  const ColumnQuadrature inner(core.mesh, narrower);
  double area = 0.0;
  for (std::size_t columns_per_side = kFirstGrid; columns_per_side <= kLastGrid / 4;
       columns_per_side *= 2) {
    const double wider_excess = outer.integrate_overlap(columns_per_side).moments.volume;
    const double narrower_excess = inner.integrate_overlap(columns_per_side).moments.volume;
    const double lost = (wider_excess - narrower_excess) / (2.0 * kAreaStep * r);
    const double before = area;
    area = skin.area - skin.overlap_area - lost;
    if (std::abs(area - before) <= 0.5 * kAreaAccuracy * area) break;
  }
  return area;
}

}  // namespace clast

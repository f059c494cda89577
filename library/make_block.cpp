#include "library/make_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "core/version.hpp"
#include "library/unscaled.hpp"
#include "massprops/principal_frame.hpp"
#include "massprops/solid.hpp"
#include "massprops/sphero.hpp"
#include "mesh/mesh_topology.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/coplanar_faces.hpp"
#include "shapes/core_fit.hpp"
#include "shapes/rounding.hpp"
#include "shapes/surface_deviation.hpp"
#include "shapes/wall_thickness.hpp"

namespace clast {

namespace {

constexpr double kMaxRadiusFraction =
    0.25;                             ///< of S; beyond it rounding, not the rock, is the shape
constexpr double kMaxMassGap = 0.05;  ///< relative; scales and densities are not that far off
constexpr double kLightestRock = 500.0, kMaxRockMass = 8000.0;  ///< kg/m^3
constexpr int kVolumeSteps = 4;  ///< the volume is close to a cubic; two or three do
/// Relative accuracy of volumes that are compared; and of those that a fit is scaled by.
constexpr double kComparedVolume = 1e-2, kScaledVolume = 1e-4;
/// Fractions of the tolerance: at which a fit ends, since the scaling to the volume takes the rest;
/// that the scaled body keeps; and that it may reach if L has decreased.
constexpr double kFitFraction = 0.93, kKeptFraction = 0.99, kScaledFraction = 0.995;
constexpr int kFitAttempts = 3;  ///< each with the L of the last body
/// Fractions of the radius by which a scan with thin walls is offset; the fit does the rest.
constexpr double kShallower[] = {0.7, 0.5, 0.35};
/// Maximum relative difference between the principal moments of a block and its scan.
constexpr double kMomentsTolerance = 5e-3;
/// Largest relative difference of the volume before scaling. Too large a radius swells it by more.
constexpr double kMaxVolumeGap = 0.03;

bool near_enough(const Block& block, const BlockOptions& options) {
  return block.deviation.hausdorff <= options.tolerance * block.box.lengths[0];
}

void check_positive(double value, const char* name, const char* unit) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw InputError(std::string(name) + " is " + format_significant(value, 4) + " " + unit +
                     "; it must be a positive number");
  }
}

/// The body with its core scaled about `centre`; the radius stays.
SpheroPolyhedron with_scaled_core(SpheroPolyhedron body, const Vec3& centre, double factor) {
  for (Vec3& vertex : body.vertices) vertex = centre + factor * (vertex - centre);
  return body;
}

/// A body and its mass properties at a density of 1 kg/m^3.
struct MeasuredBody {
  SpheroPolyhedron body;
  MassProperties unit;
};

/// Scales the core until the rounded body has the volume `target`, to its accuracy.
MeasuredBody with_volume(const SpheroPolyhedron& body, double target, double accuracy) {
  const auto measured = [&](SpheroPolyhedron tried) {
    const MassProperties unit = sphero_mass_properties(tried, 1.0, accuracy);
    return MeasuredBody{std::move(tried), unit};
  };
  MeasuredBody best = measured(body);
  const Vec3 centre = best.unit.centre;
  double factor = 1.0;
  double previous_factor = 1.0;
  double previous_gap = 0.0;
  for (int step = 0; step < kVolumeSteps; ++step) {
    const double gap = best.unit.volume - target;
    const double tolerance = std::max(0.5 * best.unit.relative_error, 1e-12);
    if (std::abs(gap) <= tolerance * target) break;
    const bool first = step == 0 || gap == previous_gap;
    const double slope =
        first ? 3.0 * best.unit.volume / factor : (gap - previous_gap) / (factor - previous_factor);
    previous_gap = gap;
    previous_factor = factor;
    factor -= gap / slope;
    best = measured(with_scaled_core(body, centre, factor));
  }
  return best;
}

/// The largest relative difference of a principal moment.
double moments_gap(const MassProperties& body, const MassProperties& scan) {
  const Vec3 ours = principal_frame(body).moments, theirs = principal_frame(scan).moments;
  return (ours.cwiseQuotient(theirs) - Vec3::Ones()).cwiseAbs().maxCoeff();
}

/// A core to start the fit from.
SpheroPolyhedron first_core(const TriangleMesh& surface, double radius, bool advise) {
  if (std::optional<SpheroPolyhedron> body = try_inset_core(surface, radius)) {
    return std::move(*body);
  }
  for (const double share : kShallower) {
    if (std::optional<SpheroPolyhedron> body = try_inset_core(surface, share * radius)) {
      body->radius = radius;
      return std::move(*body);
    }
  }
  if (advise) inset_core(surface, radius);  // throws, and says which radius works
  throw GeometryError(
      "a Minkowski radius of " + format_significant(radius, 4) +
      " m is too large for this block: its core would vanish or turn inside out; give a "
      "smaller one");
}

/// Refuses a radius that swells the body too much.
/// @param gap  relative difference of the volume from that of the scan
void check_volume_gap(double gap, double radius, const TriangleMesh& surface,
                      const BlockOptions& options) {
  if (std::abs(gap) > kMaxVolumeGap) {
    // Says what is wrong in nearly all cases; else the surface is not the scan's.
    if (options.suggest_radius) inset_core(surface, radius);
    throw GeometryError("rounded with a radius of " + format_significant(radius, 4) + " m, " +
                        std::to_string(surface.vertices.size()) + " vertices have a volume " +
                        format_significant(100.0 * std::abs(gap), 4) + " % " +
                        (gap > 0.0 ? "above" : "below") +
                        " the scan's, and scaling corrects 3 % at most; give a smaller "
                        "`radius` or more `vertices`");
  }
}

/// @param length  L of `surface`, m
CoreFit fitted_body(const TriangleMesh& surface, double length, const ScanSurface& scan,
                    double volume, double radius, const BlockOptions& options) {
  CoreFit fit{first_core(surface, radius, options.suggest_radius)};
  SpheroPolyhedron& body = fit.body;
  double L = std::min(length, smallest_box(body).lengths[0]);
  // The fit knows one skin: walls of cavities stay where the inset put them.
  const std::vector<std::uint32_t> shell_of = triangle_components(surface);
  if (*std::max_element(shell_of.begin(), shell_of.end()) == 0) {
    const auto with_scan_volume = [&](SpheroPolyhedron fitted) {
      const MassProperties unit = sphero_mass_properties(fitted, 1.0, kScaledVolume);
      const double gap = unit.volume / volume - 1.0;
      if (radius > 0.0) check_volume_gap(gap, radius, surface, options);
      return with_scaled_core(std::move(fitted), unit.centre, 1.0 - gap / 3.0);
    };
    for (int attempt = 0; attempt < kFitAttempts; ++attempt) {
      const double largest_distance = options.tolerance * L;
      fit = fit_core(scan, std::move(body),
                     {.target_distance = kFitFraction * largest_distance,
                      .max_distance = kKeptFraction * largest_distance,
                      .correct = with_scan_volume,
                      .threads = options.threads});
      const double fitted_L = smallest_box(body).lengths[0];
      const bool has_bound = fit.distance_bound <= kKeptFraction * largest_distance;
      if (!has_bound || fit.distance_bound <= kScaledFraction * options.tolerance * fitted_L) break;
      L = fitted_L;
    }
  }
  if (options.convex) {
    fit = {make_sphero_polyhedron(convex_hull(body.vertices), radius)};
  }
  if (radius > 0.0) {
    const double fitted = sphero_mass_properties(body, 1.0, kComparedVolume).volume;
    check_volume_gap(fitted / volume - 1.0, radius, surface, options);
  }
  return fit;
}

void warn_of_thin_walls(Block& block) {
  const std::optional<ThinWall> wall = find_thinnest_wall(block.surface);
  if (!wall || block.body.radius <= 0.5 * wall->thickness) return;
  block.warnings.push_back(
      "the radius " + format_significant(block.body.radius, 4) +
      " m is more than half the thinnest wall, " + format_significant(wall->thickness, 4) +
      " m near " + format_point(wall->position) + ": the block is thicker than the rock there");
}

/// Lighter than pumice or heavier than ore: a unit was mistaken, or a mass.
void warn_of_density(Block& block) {
  if (block.density >= kLightestRock && block.density <= kMaxRockMass) return;
  std::string advice = "; check mass and scale";
  if (block.density >= 1e-3 * kLightestRock && block.density <= 1e-3 * kMaxRockMass) {
    advice = "; if this is in g/cm3 or t/m3, give `density` " +
             format_significant(1000.0 * block.density, 4);
  }
  block.warnings.push_back("the density " + format_significant(block.density, 4) +
                           " kg/m3 is outside the range of rocks, 500 to 8000 kg/m3" + advice);
}

void add_warnings(Block& block, const BlockOptions& options) {
  const double L = block.box.lengths[0];
  const double S = block.box.lengths[2];
  if (block.principal.has_near_equal_moments) {
    block.warnings.push_back(
        "two principal moments are nearly equal: the directions of the principal axes are set by a "
        "convention, not by the shape");
  }
  if (block.mass.relative_error > options.accuracy) {
    block.warnings.push_back(
        "the relative error of volume and inertia is " +
        format_significant(block.mass.relative_error, 4) + ", more than the requested " +
        format_significant(options.accuracy, 4) + "; simplify the scan, or raise `accuracy`");
  }
  if (block.body.radius > kMaxRadiusFraction * S) {
    block.warnings.push_back("the radius " + format_significant(block.body.radius, 4) +
                             " m is more than a quarter of S (" + format_significant(S, 4) +
                             " m): corners and edges are strongly rounded");
  }
  if (!block.from_core) warn_of_thin_walls(block);
  warn_of_density(block);
  if (block.deviation.moments_relative > kMomentsTolerance) {
    block.warnings.push_back(
        "a principal moment differs by " +
        format_significant(100.0 * block.deviation.moments_relative, 4) +
        " % from that of the scan; give more `vertices` or a smaller `radius_share`");
  }
  if (!near_enough(block, options)) {
    block.warnings.push_back(
        "the block lies up to " + format_significant(block.deviation.hausdorff, 4) +
        " m off the scan, " + format_significant(100.0 * block.deviation.hausdorff / L, 4) +
        " % of L; give more `vertices` or a smaller `radius_share`");
  }
  if (options.mass && options.density_given) {
    const double gap = block.mass.mass / *options.mass - 1.0;
    if (std::abs(gap) > kMaxMassGap) {
      block.warnings.push_back(
          "volume times density gives " + format_significant(block.mass.mass, 4) + " kg, " +
          format_significant(std::abs(100.0 * gap), 4) + " % " + (gap > 0 ? "more" : "less") +
          " than the " + format_significant(*options.mass, 4) +
          " kg weighed; check scale, density and closed bottom");
    }
  }
}

std::string described(const BlockOptions& options, const Block& block) {
  std::string text = options.core ? "core=yes" : "core=no";
  text += (is_unscaled(block) ? " radius_units=" : " radius_m=") +
          format_significant(block.body.radius, 4);
  if (!options.radius) text += " radius_share=" + format_significant(options.radius_fraction, 4);
  text += " density_kg_m3=" + format_significant(block.density, 4);
  if (options.mass) text += " mass_kg=" + format_significant(*options.mass, 4);
  if (!options.core) text += " tolerance=" + format_significant(options.tolerance, 4);
  if (options.convex) text += " convex=yes";
  return text + " accuracy=" + format_significant(options.accuracy, 4);
}

/// Everything that follows from a body and its unit mass properties.
Block finished(Block block, MeasuredBody measured, BlockSource source,
               const BlockOptions& options) {
  block.from_core = options.core;
  block.body = std::move(measured.body);
  block.density = options.mass && !options.density_given ? *options.mass / measured.unit.volume
                                                         : options.density;
  block.mass = measured.unit;
  block.mass.mass = block.density * measured.unit.volume;
  block.mass.inertia = block.density * measured.unit.inertia;
  block.area = sphero_surface_area(block.body);
  block.principal = principal_frame(block.mass);
  block.box = smallest_box(block.body);
  block.field.weighed_mass = options.mass;

  block.source = std::move(source);
  if (!block.source.options.empty()) block.source.options += " ";
  block.source.options += described(options, block);
  block.source.program_version = version();
  add_warnings(block, options);
  return block;
}

Block block_of_body(Block block, const SpheroPolyhedron& body, BlockSource source,
                    const BlockOptions& options) {
  options.check();
  MeasuredBody measured{merge_coplanar_faces(body), {}};
  measured.unit = sphero_mass_properties(measured.body, 1.0, options.accuracy);
  return finished(std::move(block), std::move(measured), std::move(source), options);
}

Block block_of_fit(Block block, const FittedBody& fitted, const ScanSurface& scan,
                   BlockSource source, const BlockOptions& options) {
  block.surface = fitted.surface;
  const MassProperties target = solid_mass_properties(scan.mesh(), 1.0);
  MeasuredBody measured = with_volume(fitted.body, target.volume, options.accuracy);
  block.deviation = measure_surface_deviation(scan, measured.body, {.threads = options.threads});
  if (fitted.is_within_tolerance()) {
    SurfaceDeviation& deviation = block.deviation;
    for (double* bound : {&deviation.hausdorff, &deviation.scan_to_body, &deviation.body_to_scan}) {
      *bound = std::min(*bound, fitted.distance);
    }
  }
  block.deviation.volume_relative = measured.unit.volume / target.volume - 1.0;
  block.deviation.moments_relative = moments_gap(measured.unit, target);
  block = finished(std::move(block), std::move(measured), std::move(source), options);
  block.deviation.area_relative = block.area / surface_area(scan.mesh()) - 1.0;
  return block;
}

Block checked_block(Block block, const TriangleMesh& surface, const ScanSurface& scan,
                    BlockSource source, const BlockOptions& options) {
  options.check();
  if (options.core) {
    block.surface = surface;
    const SpheroPolyhedron body = make_sphero_polyhedron(surface, *options.radius);
    return block_of_body(std::move(block), body, std::move(source), options);
  }
  return block_of_fit(std::move(block), fit_body(surface, scan, options), scan, std::move(source),
                      options);
}

/// Runs `make` with an empty block of that id, and puts the id before what it refuses.
template <class Make>
Block named_block(const std::string& id, Make&& make) {
  return with_error_context("block " + id, [&] {
    Block block;
    block.id = id;
    return make(std::move(block));
  });
}

}  // namespace

void BlockOptions::check() const {
  if (core && !radius) {
    throw InputError(
        "a core needs its Minkowski radius: give `core` together with `radius` in metres");
  }
  if (radius && (!(*radius >= 0.0) || !std::isfinite(*radius))) {
    throw InputError("radius is " + format_significant(*radius, 4) +
                     " m; it must be zero or a positive number");
  }
  if (!(radius_fraction >= 0.0) || radius_fraction > kMaxRadiusFraction) {
    throw InputError("the radius as a fraction of S is " + format_significant(radius_fraction, 4) +
                     "; it must be between 0 and 0.25");
  }
  check_positive(density, "density", "kg/m3");
  if (mass) check_positive(*mass, "mass", "kg");
  if (!(accuracy >= 1e-6 && accuracy <= 1e-2)) {
    throw InputError("accuracy is " + format_significant(accuracy, 4) +
                     "; it must be between 1e-6 and 1e-2");
  }
  if (!(tolerance > 0.0 && tolerance <= 1.0)) {
    throw InputError("tolerance, a fraction of L, is " + format_significant(tolerance, 4) +
                     "; it must be more than 0 and at most 1");
  }
}

FittedBody fit_body(const TriangleMesh& surface, const ScanSurface& scan,
                    const BlockOptions& options) {
  options.check();
  const MassProperties target = solid_mass_properties(scan.mesh(), 1.0);
  const Vec3 sides = smallest_box(surface.vertices).lengths;
  const double radius = options.radius.value_or(options.radius_fraction * sides[2]);
  CoreFit fit = fitted_body(surface, sides[0], scan, target.volume, radius, options);
  const MassProperties unit = sphero_mass_properties(fit.body, 1.0, kScaledVolume);
  const double L = smallest_box(fit.body).lengths[0];
  const double tolerated = options.tolerance * L;
  // The scaling to the volume moves the surface by no more than this.
  const double move = L * (std::abs(unit.volume / target.volume - 1.0) + unit.relative_error) / 3.0;
  FittedBody result{surface, std::move(fit.body), fit.distance_bound + move};
  if (result.distance > tolerated) {
    const DeviationOptions comparison{
        .samples = 1, .limit = std::max(0.0, tolerated - move), .threads = options.threads};
    result.distance = measure_surface_deviation(scan, result.body, comparison).hausdorff + move;
  }
  result.deviation_ratio =
      std::max(result.distance / tolerated, moments_gap(unit, target) / kMomentsTolerance);
  return result;
}

Block make_block(const std::string& id, const FittedBody& fitted, const ScanSurface& scan,
                 BlockSource source, const BlockOptions& options) {
  return named_block(id, [&](Block block) {
    options.check();
    return block_of_fit(std::move(block), fitted, scan, std::move(source), options);
  });
}

Block make_block(const std::string& id, const TriangleMesh& surface, const ScanSurface& scan,
                 BlockSource source, const BlockOptions& options) {
  return named_block(id, [&](Block block) {
    return checked_block(std::move(block), surface, scan, std::move(source), options);
  });
}

Block make_block(const std::string& id, const SpheroPolyhedron& body, BlockSource source,
                 BlockOptions options) {
  options.core = true;
  options.radius = body.radius;
  return named_block(id, [&](Block block) {
    block = block_of_body(std::move(block), body, std::move(source), options);
    block.surface = body.faces.empty() ? rounded_surface_mesh(body) : core_mesh(body);
    return block;
  });
}

}  // namespace clast

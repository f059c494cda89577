#include "library/detail/varied_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "classify/surface_indices.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/detail/convexity_search.hpp"
#include "library/variation_ranges.hpp"
#include "massprops/principal_frame.hpp"
#include "massprops/sphero.hpp"
#include "mesh/decimation.hpp"
#include "shapes/surface_detail.hpp"

namespace clast::library_detail {
namespace {

constexpr double kMaxVariedRadiusFraction = kVariedRadiusFractionRange.high;
constexpr double kSameFraction = 1e-9;
constexpr int kRadiusRounds = 20;
constexpr int kMomentRounds = 40;
constexpr double kSameMoments = 1e-9;

void refuse_round_bodies(const Block& parent) {
  if (!parent.body.faces.empty()) return;
  throw GeometryError("it is a ball or a capsule, without faces or detail to vary");
}

double radius_fraction(const SpheroPolyhedron& body) {
  return body.radius / smallest_box(body).lengths[2];
}

/// Stretched to the block's own ratios, with the radius that is `share` of S.
VariationResult with_form_of(const Block& parent, SpheroPolyhedron body, double share) {
  const BoxRatios ratios = box_ratios(parent.box);
  StretchedBody result;
  // The box turns a little with the radius, and with it S.
  for (int round = 0; round < kRadiusRounds; ++round) {
    const double S = smallest_box(body).lengths[2];
    if (std::abs(body.radius - share * S) > kSameFraction * S) {
      body.radius = share * (S - 2.0 * body.radius) / (1.0 - 2.0 * share);
    }
    result = stretch_to_ratios(body, ratios);
    if (std::abs(radius_fraction(result.body) / share - 1.0) < kVariationTolerance / 10.0) break;
    if (share == 0.0) break;
    body = result.body;
  }
  return {std::move(result.body), ""};
}

/// Principal second moments of the volume over the volume, m^2, ascending.
Vec3 spread(const MassProperties& properties) {
  const Vec3 moments = principal_frame(properties).moments / properties.mass;
  const double half = 0.5 * moments.sum();
  return {half - moments[2], half - moments[1], half - moments[0]};
}

}  // namespace

VariationResult apply_variation(const Block& parent, const StretchVariation& target) {
  refuse_round_bodies(parent);
  StretchedBody stretched = stretch_to_ratios(parent.body, target.ratios);
  if (stretched.max_ratio_difference > kVariationTolerance) {
    const BoxRatios nearest = box_ratios(smallest_box(stretched.body));
    throw GeometryError("I/L = " + format_significant(target.ratios.i_l, 4) +
                        " and S/L = " + format_significant(target.ratios.s_l, 4) +
                        " can't be reached; the nearest are " + format_significant(nearest.i_l, 4) +
                        " and " + format_significant(nearest.s_l, 4));
  }
  const Vec3& s = stretched.principal_stretches;
  return {std::move(stretched.body), "stretch=" + format_significant(s[0], 4) + "," +
                                         format_significant(s[1], 4) + "," +
                                         format_significant(s[2], 4)};
}

VariationResult apply_variation(const Block& parent, const ConvexityVariation& target) {
  refuse_round_bodies(parent);
  const double own = convexity(parent.body, parent.mass.volume);
  return {find_body_with_convexity(parent.body, own, target.convexity),
          "parent_convexity=" + format_significant(own, 4)};
}

VariationResult apply_variation(const Block& parent, const RoundingVariation& target) {
  refuse_round_bodies(parent);
  if (!(target.radius_fraction >= 0.0 && target.radius_fraction <= kMaxVariedRadiusFraction)) {
    throw InputError("a radius of " + format_significant(target.radius_fraction, 4) +
                     " of S can't be reached: must be from 0 to " +
                     format_significant(kMaxVariedRadiusFraction, 2));
  }
  const double own = radius_fraction(parent.body);
  const std::string figures = "parent_radius_share=" + format_significant(own, 4);
  if (std::abs(target.radius_fraction - own) <= kSameFraction) return {parent.body, figures};
  return {with_form_of(parent, parent.body, target.radius_fraction).body, figures};
}

VariationResult apply_variation(const Block& parent, const VertexCountVariation& target) {
  refuse_round_bodies(parent);
  const std::size_t own = parent.body.vertices.size();
  if (target.vertices < kMinVariedVertices || target.vertices > own) {
    throw InputError(format_count(target.vertices, "vertex", "vertices") + " can't be reached: " +
                     std::to_string(kMinVariedVertices) + " to the " + std::to_string(own) +
                     " of the block can; for more, reconstruct it from its scan");
  }
  const std::string figures = "parent_vertices=" + std::to_string(own);
  if (target.vertices == own) return {parent.body, figures};
  TriangleMesh core = core_mesh(parent.body);
  // About its middle, or map coordinates would cost digits.
  for (Vec3& vertex : core.vertices) vertex -= parent.box.centre;
  std::optional<TriangleMesh> fewer =
      untangle_self_intersections(decimate_mesh(core, target.vertices));
  if (!fewer || !(signed_volume(*fewer) > 0.0)) {
    throw GeometryError("with " + std::to_string(target.vertices) +
                        " vertices its core would cross itself; give more");
  }
  for (Vec3& vertex : fewer->vertices) vertex += parent.box.centre;
  return {with_form_of(parent, make_sphero_polyhedron(*fewer, parent.body.radius),
                       radius_fraction(parent.body))
              .body,
          figures};
}

VariationResult apply_variation(const Block& parent, const DetailVariation& target) {
  refuse_round_bodies(parent);
  const SurfaceDetailOptions options = {target.gain, target.degree};
  if (target.gain == 1.0) return {parent.body, "coarse_form=unchanged"};
  const ScaledDetailSurface surface = scale_surface_detail(core_mesh(parent.body), options);
  const bool harmonics = surface.coarse_shape_method == CoarseShapeMethod::kHarmonics;
  return {with_form_of(parent, make_sphero_polyhedron(surface.mesh, parent.body.radius),
                       radius_fraction(parent.body))
              .body,
          std::string("coarse_form=") + (harmonics ? "spherical_harmonics" : "bilaplacian")};
}

VariationResult apply_variation(const Block& parent, const ReferenceVariation& target) {
  const double share = std::min(parent.body.faces.empty() ? 0.0 : radius_fraction(parent.body),
                                kMaxVariedRadiusFraction);
  return {make_reference_body(target.form, {.ratios = box_ratios(parent.box),
                                            .radius_fraction = share,
                                            .exponent = target.exponent}),
          target.form == ReferenceShape::kSuperellipsoid
              ? "exponent=" + format_significant(target.exponent, 4)
              : ""};
}

VariationResult apply_variation(const Block& parent, const InertiaVariation& target) {
  const Vec3 target_spread = spread(parent.mass);
  const double side = parent.body.faces.empty() ? 0.0 : radius_fraction(parent.body);
  const double share = std::min(side, kMaxVariedRadiusFraction);
  // Half-axes a of an ellipsoid have a^2/5, half-sides of a box a^2/3; the order is that of z, y,
  // x.
  const double part = target.form == ReferenceShape::kEllipsoid ? 5.0 : 3.0;
  const Vec3 half = (part * target_spread).cwiseSqrt();
  const BoxRatios ratios = {half[1] / half[2], half[0] / half[2]};
  SpheroPolyhedron body =
      scaled(make_reference_body(target.form, {.ratios = ratios, .radius_fraction = share}),
             2.0 * half[2]);
  double gap = 1.0;
  for (int round = 0; round < kMomentRounds && gap > kSameMoments; ++round) {
    const Vec3 now = spread(sphero_mass_properties(body, 1.0));
    const Vec3 factors = target_spread.cwiseQuotient(now).cwiseSqrt();
    gap = (factors - Vec3::Ones()).cwiseAbs().maxCoeff();
    // x is the longest axis: it has the largest variance.
    for (Vec3& v : body.vertices) v = v.cwiseProduct(Vec3(factors[2], factors[1], factors[0]));
  }
  if (gap > kVariationTolerance) {
    throw GeometryError(
        "no " + name_of(target.form) + " with a radius of " + format_significant(share, 4) +
        " of S has the principal moments of the block; the lengths of the nearest body differ by " +
        format_percent(gap));
  }
  return {std::move(body), ""};
}

VariationResult apply_variation(const Block& parent, const SampledFormVariation& target) {
  refuse_round_bodies(parent);
  Block filled = parent;
  std::string figures;
  if (target.convexity) {
    const double own = convexity(parent.body, parent.mass.volume);
    if (*target.convexity > own) {
      filled.body = find_body_with_convexity(parent.body, own, *target.convexity);
    }
    figures = " parent_convexity=" + format_significant(own, 4);
  }
  VariationResult stretched = apply_variation(filled, StretchVariation{target.ratios});
  stretched.record += figures;
  return stretched;
}

}  // namespace clast::library_detail

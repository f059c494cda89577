// Surfaces between a rock and its hull, with more or less detail, and reference bodies.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "mesh/self_intersection.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/hull_interpolation.hpp"
#include "shapes/reference_bodies.hpp"
#include "shapes/star_shape.hpp"
#include "shapes/surface_detail.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

TriangleMesh bumpy_rock() { return rock_mesh(4, Vec3(1.0, 0.8, 0.6), 3, 0.25); }

/// A square ring: no point sees all of it.
TriangleMesh ring() {
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const double r : {2.0, 1.0}) {
      for (int i = 0; i < 4; ++i) {
        mesh.vertices.emplace_back(i == 0 || i == 3 ? r : -r, i < 2 ? r : -r, z);
      }
    }
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t k = (i + 1) % 4;
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    };
    quad(i, k, 8 + k, 8 + i);            // outside
    quad(4 + k, 4 + i, 12 + i, 12 + k);  // inside
    quad(8 + i, 8 + k, 12 + k, 12 + i);  // above
    quad(k, i, 4 + i, 4 + k);            // below
  }
  return mesh;
}

TEST(StarShape, ACentreSeesTheWholeSurfaceAndARingHasNone) {
  const TriangleMesh rock = bumpy_rock();
  const std::optional<Vec3> centre = find_kernel_centroid(rock);
  ASSERT_TRUE(centre);
  for (const TriangleMesh::Triangle& t : rock.triangles) {
    const Vec3 &a = rock.vertices[t[0]], &b = rock.vertices[t[1]], &c = rock.vertices[t[2]];
    EXPECT_GT((b - a).cross(c - a).dot(a - *centre), 0.0);
  }
  ASSERT_GT(enclosed_volume(ring()), 0.0);
  EXPECT_FALSE(find_kernel_centroid(ring()));
}

TEST(HullInterpolation, GoesFromTheRockToItsHullAndNeverCrossesItself) {
  const TriangleMesh rock = bumpy_rock();
  const HullInterpolation blend(rock);
  const double hull = enclosed_volume(convex_hull(rock.vertices));
  EXPECT_NEAR(blend.hull_volume(), hull, 1e-9 * hull);
  EXPECT_EQ(blend.interpolate(0.0, 0).vertices, rock.vertices);
  double before = enclosed_volume(rock);
  EXPECT_LT(before, 0.97 * hull);
  for (const double part : {0.3, 0.7, 1.0}) {
    const double volume = enclosed_volume(blend.interpolate(part, 0));
    EXPECT_GT(volume, before);
    before = volume;
  }
  for (const double part : {0.0, 0.5, 0.95}) {
    EXPECT_TRUE(find_self_intersections(blend.interpolate(part, blend.edge_flips())).empty());
  }
  EXPECT_NEAR(enclosed_volume(blend.interpolate(1.0, blend.edge_flips())), hull, 1e-6 * hull);
  EXPECT_TRUE(
      contains(refusal<GeometryError>([] { HullInterpolation{ring()}; }), "not star-shaped"));
}

// An ellipsoid near a sphere has harmonics of even degree alone, which fall off fast: nearly all of
// it is coarse form. A ripple of degree 12 is all detail.
TEST(SurfaceDetail, IsWhatLiesAboveTheDegree) {
  const auto rippled = [](double height) {
    TriangleMesh mesh = geodesic_sphere(8);
    for (Vec3& v : mesh.vertices) {
      const double angle = std::atan2(v.y(), v.x()), across = std::hypot(v.x(), v.y());
      v *= 1.0 + height * std::pow(across, 12.0) * std::cos(12.0 * angle);
    }
    return mesh;
  };
  const auto far = [](const TriangleMesh& mesh) {
    double most = 0.0;
    for (const Vec3& v : mesh.vertices) most = std::max(most, std::abs(v.norm() - 1.0));
    return most;
  };
  const TriangleMesh mesh = rippled(0.05);
  EXPECT_NEAR(far(mesh), 0.05, 1e-3);
  const ScaledDetailSurface smooth = scale_surface_detail(mesh, {.gain = 0.0, .degree = 6});
  EXPECT_EQ(smooth.coarse_shape_method, CoarseShapeMethod::kHarmonics);
  EXPECT_LT(far(smooth.mesh), 2e-3);
  EXPECT_NEAR(far(scale_surface_detail(mesh, {.gain = 2.0, .degree = 6}).mesh), 0.1, 3e-3);
  EXPECT_EQ(scale_surface_detail(mesh, {.gain = 1.0, .degree = 6}).mesh.vertices, mesh.vertices);
}

TEST(SurfaceDetail, FallsBackToABilaplacianAndSaysSo) {
  const ScaledDetailSurface smooth = scale_surface_detail(ring(), {.gain = 0.9, .degree = 6});
  EXPECT_EQ(smooth.coarse_shape_method, CoarseShapeMethod::kBilaplacian);
  EXPECT_TRUE(find_self_intersections(smooth.mesh).empty());
  EXPECT_TRUE(
      contains(refusal([] { scale_surface_detail(bumpy_rock(), {.gain = 0.0, .degree = 12}); }),
               "needs 338 vertices, and there are 162"));
  EXPECT_TRUE(contains(refusal<GeometryError>(
                           [] { scale_surface_detail(bumpy_rock(), {.gain = 10.0, .degree = 2}); }),
                       "detail times 10"));
  EXPECT_TRUE(
      contains(refusal([] { scale_surface_detail(ring(), {.gain = NAN}); }), "`detail` = nan"));
}

TEST(ReferenceBodies, HaveTheRatiosAskedFor) {
  for (const std::string& name : reference_shape_names()) {
    const ReferenceShape form = parse_reference_shape(name);
    EXPECT_EQ(name_of(form), name);
    BoxRatios ratios = {0.7, 0.4};
    const SpheroPolyhedron body =
        make_reference_body(form, {.ratios = ratios, .radius_fraction = 0.05});
    if (form == ReferenceShape::kSphere || form == ReferenceShape::kEota111) ratios = {1.0, 1.0};
    if (form == ReferenceShape::kEota221) ratios = {1.0, 0.5};
    const OrientedBox box = smallest_box(body);
    EXPECT_NEAR(box.lengths[0], 1.0, 1e-9) << name;
    EXPECT_LT(max_ratio_difference(box_ratios(box), ratios), 1e-3) << name;
    if (form != ReferenceShape::kSphere) {
      EXPECT_NEAR(body.radius, 0.05 * box.lengths[2], 1e-4) << name;
    }
  }
  EXPECT_TRUE(contains(refusal([] { parse_reference_shape("cone"); }), "eota-111"));
}

// 1 m^3 of the published bodies is 1.122 m wide as a cube, and 1.4136 x 1.4136 x 0.7068 m as a
// plate; each has 24 corners.
TEST(ReferenceBodies, OfEotaHaveThePublishedExtentsAtACubicMetre) {
  const SpheroPolyhedron cube = make_reference_body(ReferenceShape::kEota111, {});
  const SpheroPolyhedron plate = make_reference_body(ReferenceShape::kEota221, {});
  EXPECT_EQ(cube.vertices.size(), 24u);
  EXPECT_EQ(plate.vertices.size(), 24u);
  EXPECT_NEAR(1.0 / std::cbrt(enclosed_volume(core_mesh(cube))), 1.122, 5e-4);
  EXPECT_NEAR(1.0 / std::cbrt(enclosed_volume(core_mesh(plate))), 1.413631418, 1e-3);
}

// Volumes in closed form: a box is filled, an elliptic cylinder to pi/4, an ellipsoid to pi/6, but
// for what chords cut off.
TEST(ReferenceBodies, FillTheirBoxesAsTheyShould) {
  const auto filled = [](ReferenceShape form, double exponent = 4.0) {
    const SpheroPolyhedron body =
        make_reference_body(form, {.ratios = {0.7, 0.4}, .exponent = exponent});
    return enclosed_volume(core_mesh(body)) / smallest_box(body).volume();
  };
  EXPECT_NEAR(filled(ReferenceShape::kBox), 1.0, 1e-9);
  EXPECT_NEAR(filled(ReferenceShape::kCylinder), kPi / 4.0, 0.01);
  EXPECT_NEAR(filled(ReferenceShape::kEllipsoid), kPi / 6.0, 0.02);
  EXPECT_NEAR(filled(ReferenceShape::kSuperellipsoid, 2.0), filled(ReferenceShape::kEllipsoid),
              1e-6);
  EXPECT_GT(filled(ReferenceShape::kSuperellipsoid, 8.0), 0.75);
}

}  // namespace
}  // namespace clast

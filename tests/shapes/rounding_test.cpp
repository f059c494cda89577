#include "shapes/rounding.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "shapes/surface_deviation.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

/// Distance from p to triangle abc by trying all features: a second method beside the tree.
double distance_to_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const auto to_segment = [&](const Vec3& s, const Vec3& e) {
    const double t = std::clamp((p - s).dot(e - s) / (e - s).squaredNorm(), 0.0, 1.0);
    return (p - s - t * (e - s)).norm();
  };
  double best = std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
  const Vec3 n = (b - a).cross(c - a).normalized();
  const Vec3 q = p - n.dot(p - a) * n;
  if (n.dot((b - a).cross(q - a)) >= 0 && n.dot((c - b).cross(q - b)) >= 0 &&
      n.dot((a - c).cross(q - c)) >= 0) {
    best = std::min(best, std::abs(n.dot(p - a)));
  }
  return best;
}

/// What a bound may lie above the largest distance, share of the diagonal (see the header).
constexpr double kGap = 2e-5;

std::string rounding_refusal(const TriangleMesh& scan, double radius) {
  try {
    inset_core(scan, radius);
  } catch (const GeometryError& error) {
    return error.what();
  }
  return {};
}

TEST(Rounding, CoreOfACubeIsTheSmallerCube) {
  Random random(4);
  const Pose pose{Vec3(888600, 6671300, 200), random.rotation()};
  for (const int n : {1, 2, 5, 9}) {
    for (const double r : {0.01, 0.05, 0.1}) {
      const TriangleMesh cube = box_mesh({1, 1, 1}, n);
      const SpheroPolyhedron body = inset_core(cube, r);
      const TriangleMesh core = core_mesh(body);
      EXPECT_EQ(body.radius, r);
      EXPECT_NEAR((bounds(core).low - Vec3::Constant(r)).norm(), 0.0, 1e-14);
      EXPECT_NEAR((bounds(core).high - Vec3::Constant(1 - r)).norm(), 0.0, 1e-14);
      EXPECT_NEAR(enclosed_volume(core), std::pow(1 - 2 * r, 3), 1e-13);
      EXPECT_NEAR(surface_area(core), 6 * std::pow(1 - 2 * r, 2), 1e-13);
      const TriangleMesh turned = core_mesh(inset_core(transformed(cube, pose), r));
      EXPECT_NEAR(enclosed_volume(turned), std::pow(1 - 2 * r, 3), 1e-8);
    }
  }
}

TEST(Rounding, RadiusAboveTheMeshSizeStillGivesTheSmallerBox) {
  // Spacing 1/20, 2/20 and 3/20 against a radius of 0.2: vertices near the edges must go.
  const SpheroPolyhedron body = inset_core(box_mesh({1, 2, 3}, 20), 0.2);
  const TriangleMesh core = core_mesh(body);
  EXPECT_NEAR(enclosed_volume(core), 0.6 * 1.6 * 2.6, 1e-12);
  EXPECT_NEAR(surface_area(core), 2 * (0.6 * 1.6 + 0.6 * 2.6 + 1.6 * 2.6), 1e-12);
  EXPECT_TRUE(inspect_mesh(core).is_closed() && inspect_mesh(core).is_oriented());
}

TEST(Rounding, TetrahedronShrinksAboutItsIncentre) {
  // Every plane comes in by r: a homothety about the incentre by 1 - r / inradius.
  const double area = 1.5 + 0.5 * std::sqrt(3.0), inradius = 3.0 * (1.0 / 6.0) / area;
  const double r = 0.1;
  const TriangleMesh core = core_mesh(inset_core(tetrahedron(), r));
  const double k = 1.0 - r / inradius;
  const Vec3 incentre = Vec3::Constant(inradius);
  for (std::size_t v = 0; v < 4; ++v) {
    const Vec3 expected = incentre + k * (tetrahedron().vertices[v] - incentre);
    EXPECT_NEAR((core.vertices[v] - expected).norm(), 0.0, 1e-14);
  }
}

TEST(Rounding, ZeroRadiusKeepsTheScan) {
  const TriangleMesh rock = random_rock(1);
  EXPECT_EQ(core_mesh(inset_core(rock, 0.0)).vertices, rock.vertices);
}

TEST(Rounding, TooLargeARadiusIsRefusedWithOneThatWorks) {
  const std::string message = rounding_refusal(box_mesh({1, 1, 1}), 0.6);
  EXPECT_NE(message.find("0.6 m is too large"), std::string::npos) << message;
  const std::size_t at = message.find("turn inside out; ");
  ASSERT_NE(at, std::string::npos) << message;
  const double works = std::stod(message.substr(at + 17));
  EXPECT_NEAR(works, 0.5, 0.02);
  EXPECT_LT(works, 0.5);
  EXPECT_NO_THROW(inset_core(box_mesh({1, 1, 1}), works));
  EXPECT_NE(rounding_refusal(box_mesh({1, 1, 0.1}, 4), 0.06), "");
}

TEST(Rounding, OpenInwardAndBadRadiusAreRefused) {
  TriangleMesh open = tetrahedron();
  open.triangles.pop_back();
  EXPECT_NE(rounding_refusal(open, 0.01).find("closed"), std::string::npos);
  TriangleMesh inward = tetrahedron();
  for (TriangleMesh::Triangle& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_NE(rounding_refusal(inward, 0.01).find("inwards"), std::string::npos);
  EXPECT_THROW(inset_core(tetrahedron(), -0.1), InputError);
  EXPECT_THROW(inset_core(tetrahedron(), std::nan("")), InputError);
}

TEST(SurfaceDeviation, OfASharpCubeIsItsMissingCorner) {
  // The rounded cube touches all faces; its corners are r (sqrt 3 - 1) short of the sharp ones.
  const double r = 0.1;
  const TriangleMesh cube = box_mesh({1, 1, 1});
  const SurfaceDeviation deviation = measure_surface_deviation(cube, inset_core(cube, r));
  const double corner = r * (std::sqrt(3.0) - 1.0);
  EXPECT_GE(deviation.hausdorff, corner - 1e-12);
  EXPECT_LE(deviation.hausdorff, corner + kGap * std::sqrt(3.0));
  EXPECT_EQ(deviation.scan_to_body, deviation.hausdorff);
  // No point of the rounded cube is farther than the middle of its corners.
  EXPECT_GE(deviation.body_to_scan, r - r / std::sqrt(3.0) - 1e-12);
  EXPECT_LE(deviation.body_to_scan, r - r / std::sqrt(3.0) + kGap * std::sqrt(3.0));
  EXPECT_EQ(deviation.volume_relative, 0.0);
}

// Faces of a thin slab and of a needle lie just under the skin everywhere: bounding them by their
// size would give many times the true distance.
TEST(SurfaceDeviation, OfLargeThinFacesIsThatOfTheirCorners) {
  for (const Vec3& sides : {Vec3(2, 1.5, 0.1), Vec3(1, 1, 0.001), Vec3(1, 0.01, 0.01)}) {
    const double r = 0.02 * sides.minCoeff();
    const TriangleMesh slab = box_mesh(sides);
    TriangleMesh core = slab;  // every side moved in by r, then pushed out again by 0.01 r
    for (Vec3& v : core.vertices) {
      for (int k = 0; k < 3; ++k) v[k] += (v[k] > 0.0 ? -0.99 : 0.99) * r;
    }
    const SurfaceDeviation deviation =
        measure_surface_deviation(slab, make_sphero_polyhedron(core, r));
    const double corner = r * (0.99 * std::sqrt(3.0) - 1.0), gap = 2e-5 * sides.norm();
    EXPECT_GE(deviation.scan_to_body, corner * (1.0 - 1e-9));
    EXPECT_LE(deviation.scan_to_body, corner + gap);
    EXPECT_LE(deviation.body_to_scan, r * (1.0 - 1.0 / std::sqrt(3.0)) + gap);
  }
}

TEST(SurfaceDeviation, MeanOfASharpCubeIsTheIntegralOverItsRims) {
  // At distance s < r from an edge the gap is sqrt(r^2 + (r-s)^2) - r along the foot at the edge of
  // the core; integrated over the rims of the six faces, corners in two dimensions.
  const double r = 0.1;
  constexpr int n = 400;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = (i + 0.5) / n, y = (j + 0.5) / n;
      const double dx = std::max({r - x, x - (1 - r), 0.0}),
                   dy = std::max({r - y, y - (1 - r), 0.0});
      sum += std::sqrt(dx * dx + dy * dy + r * r) - r;
    }
  }
  const double expected = sum / (n * n);
  const TriangleMesh cube = box_mesh({1, 1, 1});
  const SurfaceDeviation deviation =
      measure_surface_deviation(cube, inset_core(cube, r), {.samples = 200000});
  EXPECT_NEAR(deviation.mean / expected, 1.0, 0.01);
}

TEST(SurfaceDeviation, OfTheScanTakenAsCoreIsTheRadius) {
  // Where it is convex; under a reflex edge the skin is farther.
  const TriangleMesh box = box_mesh({1, 2, 3}, 3);
  const SurfaceDeviation deviation =
      measure_surface_deviation(box, make_sphero_polyhedron(box, 0.03));
  EXPECT_NEAR(deviation.mean, 0.03, 1e-12);
  // The bound is at its worst where the distance is the same everywhere.
  EXPECT_GE(deviation.hausdorff, 0.03);
  EXPECT_LE(deviation.hausdorff, 0.045);
  const TriangleMesh rock = random_rock(2);
  EXPECT_GE(
      measure_surface_deviation(rock, make_sphero_polyhedron(rock, 0.03), {.samples = 1000}).mean,
      0.03 - 1e-12);
  const SurfaceDeviation none =
      measure_surface_deviation(rock, make_sphero_polyhedron(rock, 0.0), {.samples = 1000});
  EXPECT_LT(none.hausdorff, kGap * bounds(rock).diagonal());
}

TEST(SurfaceDeviation, SeesWhatOnlyTheBodyHas) {
  // A body with a spike far from the scan: only the way body to scan finds its height.
  TriangleMesh spiked = box_mesh({1, 1, 1}, 10);
  for (Vec3& v : spiked.vertices) {
    if ((v - Vec3(0.5, 0.5, 1)).norm() < 1e-9) v.z() = 1.5;
  }
  const TriangleMesh box = box_mesh({1, 1, 1});
  const double gap = kGap * bounds(spiked).diagonal();
  const SurfaceDeviation body = measure_surface_deviation(box, make_sphero_polyhedron(spiked, 0.0));
  EXPECT_GE(body.body_to_scan, 0.5 - 1e-12);
  EXPECT_LE(body.body_to_scan, 0.5 + gap);
  EXPECT_LT(body.scan_to_body, 0.1);
  const SurfaceDeviation scan = measure_surface_deviation(spiked, make_sphero_polyhedron(box, 0.0));
  EXPECT_GE(scan.scan_to_body, 0.5 - 1e-12);
  EXPECT_LE(scan.scan_to_body, 0.5 + gap);
  EXPECT_LT(scan.body_to_scan, 0.1);
}

TEST(SurfaceDeviation, InsideTheCoreCountsFromTheSkin) {
  const SurfaceDeviation deviation = measure_surface_deviation(
      scaled(box_mesh({1, 1, 1}), 0.5), make_sphero_polyhedron(box_mesh({1, 1, 1}), 0.1));
  // The corner (1/2, 1/2, 1/2) of the small cube is half a unit inside the core, 0.6 under the
  // skin.
  EXPECT_GE(deviation.hausdorff, 0.6 - 1e-12);
}

TEST(SurfaceDeviation, AFilledSlotCountsByItsDepth) {
  // A slot narrower than twice the radius is filled by the body: its floor lies a whole slot's
  // depth under the skin, although core and radius are nowhere farther than a little from it.
  const auto slotted = [](double half_width, double floor) {
    TriangleMesh block = box_mesh({1, 1, 1}, 2);
    for (Vec3& v : block.vertices) {
      if (v.x() == 0.5 && v.z() == 1.0)
        v.z() = floor;
      else if (v.z() == 1.0 && v.x() < 0.5)
        v.x() += 0.5 - half_width;
      else if (v.z() == 1.0 && v.x() > 0.5)
        v.x() -= 0.5 - half_width;
    }
    return block;
  };
  const double r = 0.1;
  const TriangleMesh core = slotted(0.02, 0.4);
  const TriangleMesh scan = slotted(0.04, 0.45);
  const SurfaceDeviation deviation =
      measure_surface_deviation(scan, make_sphero_polyhedron(core, r));
  // The skin over the slot is about r above the core's rims at z = 1.
  EXPECT_GT(deviation.scan_to_body, 0.45);
}

TEST(SurfaceDeviation, BoundsHoldAgainstDenseSampling) {
  for (const int seed : {1, 2, 3}) {
    const TriangleMesh rock = random_rock(seed, 2, 0.1);
    const SpheroPolyhedron body = inset_core(random_rock(seed, 2, 0.08), 0.08);
    const SurfaceDeviation deviation = measure_surface_deviation(rock, body);
    const TriangleMesh core = core_mesh(body), skin = rounded_surface_mesh(body, 12);
    double sampled = 0.0;
    for (const Vec3& p : skin.vertices) {
      double to_core = 1e300, to_rock = 1e300;
      for (const TriangleMesh::Triangle& t : core.triangles) {
        to_core = std::min(to_core, distance_to_triangle(core.vertices[t[0]], core.vertices[t[1]],
                                                         core.vertices[t[2]], p));
      }
      if (to_core < body.radius * (1.0 - 1e-9)) continue;  // buried at a reflex edge
      for (const TriangleMesh::Triangle& t : rock.triangles) {
        to_rock = std::min(to_rock, distance_to_triangle(rock.vertices[t[0]], rock.vertices[t[1]],
                                                         rock.vertices[t[2]], p));
      }
      sampled = std::max(sampled, to_rock);
    }
    EXPECT_GE(deviation.body_to_scan, sampled - 1e-12);
    // The farthest point is between samples.
    EXPECT_LE(deviation.body_to_scan, 1.05 * sampled + 4e-4 * bounds(rock).diagonal());
  }
}

TEST(SurfaceDeviation, IsTheSameOnAnyNumberOfThreads) {
  const TriangleMesh rock = random_rock(3, 3, 0.1);
  const SpheroPolyhedron body = inset_core(rock, 0.1);
  const SurfaceDeviation one = measure_surface_deviation(rock, body);
  const SurfaceDeviation four = measure_surface_deviation(rock, body, {.threads = 4});
  EXPECT_EQ(one.scan_to_body, four.scan_to_body);
  EXPECT_EQ(one.body_to_scan, four.body_to_scan);
  EXPECT_EQ(one.mean, four.mean);
}

TEST(SurfaceDeviation, ALimitDecidesAsTheWholeSearchDoes) {
  const TriangleMesh rock = random_rock(4, 3, 0.1);
  const SpheroPolyhedron body = inset_core(rock, 0.1);
  const double whole = measure_surface_deviation(rock, body).hausdorff;
  for (const double factor : {0.5, 0.9, 1.01, 1.5}) {
    const double limit = factor * whole;
    const double quick = measure_surface_deviation(rock, body, {.limit = limit}).hausdorff;
    EXPECT_EQ(quick <= limit, whole <= limit) << factor;
    if (quick > limit) {
      EXPECT_LE(quick, whole) << factor;
    }
  }
}

TEST(SurfaceDeviation, EmptySurfacesAreRefused) {
  EXPECT_THROW(
      measure_surface_deviation(TriangleMesh{}, make_sphero_polyhedron(tetrahedron(), 0.1)),
      GeometryError);
  EXPECT_THROW(measure_surface_deviation(tetrahedron(), {}), GeometryError);
}

class RoundedRocks : public testing::TestWithParam<int> {};

TEST_P(RoundedRocks, StayCloseToTheScanAndSound) {
  const TriangleMesh rock = random_rock(GetParam(), 3, 0.03);
  const double thickness = (bounds(rock).high - bounds(rock).low).minCoeff();
  for (const double share : {0.02, 0.05, 0.1}) {
    const double r = share * thickness;
    const SpheroPolyhedron body = inset_core(rock, r);
    const TriangleMesh core = core_mesh(body);
    EXPECT_TRUE(inspect_mesh(core).is_closed() && inspect_mesh(core).is_oriented());
    EXPECT_TRUE(find_self_intersections(core).empty());
    EXPECT_GT(enclosed_volume(core), 0.0);
    const SurfaceDeviation deviation = measure_surface_deviation(rock, body, {.samples = 5000});
    EXPECT_LT(deviation.hausdorff, 0.5 * r + 0.02 * thickness);
    EXPECT_LT(deviation.mean, 0.1 * r);
  }
}

TEST_P(RoundedRocks, DeviationAgreesWithBruteForce) {
  const TriangleMesh rock = random_rock(GetParam(), 2, 0.05);
  const SpheroPolyhedron body = inset_core(rock, 0.05);
  const TriangleMesh core = core_mesh(body);
  double largest = 0.0;
  for (const Vec3& p : rock.vertices) {
    double nearest = 1e300;
    for (const TriangleMesh::Triangle& t : core.triangles) {
      nearest = std::min(nearest, distance_to_triangle(core.vertices[t[0]], core.vertices[t[1]],
                                                       core.vertices[t[2]], p));
    }
    largest = std::max(largest, std::abs(nearest - body.radius));
  }
  EXPECT_GE(measure_surface_deviation(rock, body, {.samples = 100}).hausdorff, largest - 1e-13);
  const SurfaceDeviation twice = measure_surface_deviation(rock, body, {.samples = 100});
  EXPECT_EQ(twice.mean, measure_surface_deviation(rock, body, {.samples = 100}).mean);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RoundedRocks, testing::Range(0, 4));

}  // namespace
}  // namespace clast

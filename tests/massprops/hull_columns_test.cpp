/// The closed form of rounded hulls against a fine grid of lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "massprops/line_pieces.hpp"
#include "massprops/moments.hpp"
#include "massprops/sphero.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {

using namespace massprops_detail;

namespace {

/// Moments of the rounded hull from its definition and a fine grid of lines alone: balls on the
/// vertices, whole cylinders on the edges, slabs over the faces. A convex body cuts a line in one
/// interval, from the lowest to the highest point of any of them.
SolidMoments hull_by_columns(const TriangleMesh& hull, double r, int per_side) {
  std::vector<OffsetPiece> parts;
  Bounds all = bounds(hull);
  all.low -= Vec3::Constant(r);
  all.high += Vec3::Constant(r);
  const auto add = [&](OffsetPiece::CurvedFace round, const Vec3& p, const Vec3& q) {
    OffsetPiece part;
    part.curved_face = round;
    part.centre = p;
    part.box = all;
    if (round == OffsetPiece::CurvedFace::cylinder) {
      part.axis = (q - p).normalized();
      part.planes = {{-part.axis, -part.axis.dot(p)}, {part.axis, part.axis.dot(q)}};
    }
    parts.push_back(part);
  };
  for (const Vec3& v : hull.vertices) add(OffsetPiece::CurvedFace::sphere, v, v);
  for (const auto& t : hull.triangles) {
    const Vec3 &a = hull.vertices[t[0]], &b = hull.vertices[t[1]], &c = hull.vertices[t[2]];
    const Vec3 n = (b - a).cross(c - a).normalized();
    OffsetPiece slab;
    slab.box = all;
    slab.planes = {{n, n.dot(a) + r}, {-n, r - n.dot(a)}};
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const Vec3 outward = (q - p).cross(n);
      slab.planes.push_back({outward, outward.dot(p)});
      add(OffsetPiece::CurvedFace::cylinder, p, q);
    }
    parts.push_back(slab);
  }
  const PieceLineClipper lines(parts, r);
  const Vec3 step = (all.high - all.low) / per_side;
  SolidMoments sum;
  for (int j = 0; j < per_side; ++j) {
    const double y = all.low.y() + (j + 0.5) * step.y();
    std::vector<LineInterval> chords(per_side, LineInterval{1e300, -1e300});
    for (std::size_t part = 0; part < lines.size(); ++part) {
      const LineInterval reach = lines.x_range(part, y);
      const int first = int(std::ceil((reach.low - all.low.x()) / step.x() - 0.5));
      for (int i = std::max(first, 0); i < per_side; ++i) {
        const double x = all.low.x() + (i + 0.5) * step.x();
        if (x > reach.high) break;
        const LineInterval cut = lines.clip_line(part, x, y);
        if (!(cut.low < cut.high)) continue;
        chords[i].low = std::min(chords[i].low, cut.low);
        chords[i].high = std::max(chords[i].high, cut.high);
      }
    }
    for (int i = 0; i < per_side; ++i) {
      const auto [low, high] = chords[i];
      if (!(low < high)) continue;
      const Vec2 xy(all.low.x() + (i + 0.5) * step.x(), y);
      const double length = high - low, first = 0.5 * (high * high - low * low);
      SolidMoments m;
      m.volume = length;
      m.first << xy * length, first;
      m.second.topLeftCorner<2, 2>() = length * xy * xy.transpose();
      m.second.topRightCorner<2, 1>() = first * xy;
      m.second.bottomLeftCorner<1, 2>() = first * xy.transpose();
      m.second(2, 2) = (high * high * high - low * low * low) / 3.0;
      sum.add_scaled(m, step.x() * step.y());
    }
  }
  return sum;
}

class RandomHull : public testing::TestWithParam<unsigned> {};

TEST_P(RandomHull, ClosedFormAgreesWithColumnsToAMillionth) {
  Random random(GetParam());
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i)
    points.push_back(random.unit_vector().cwiseProduct(Vec3(1, 0.8, 0.6)));
  const TriangleMesh hull = convex_hull(points);
  const double r = random.uniform(0.1, 0.3);
  const MassProperties exact = convex_sphero_mass_properties(make_sphero_polyhedron(hull, r), 1.0);
  const MassProperties sampled =
      to_mass_properties(hull_by_columns(hull, r, 3000), Vec3::Zero(), Mat3::Identity(), 1.0);
  EXPECT_NEAR(sampled.volume / exact.volume, 1.0, 1e-6);
  EXPECT_LT((sampled.centre - exact.centre).norm(), 1e-6);
  EXPECT_TRUE(sampled.inertia.isApprox(exact.inertia, 1e-6));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomHull, testing::Range(1u, 4u));

}  // namespace
}  // namespace clast

#include "massprops/offset_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "massprops/normal_cone.hpp"
#include "mesh/half_edges.hpp"

namespace clast::massprops_detail {
namespace {

// A triangle lower than this share of the core's diagonal has no usable normal.
constexpr double kSliver = 1e-10;
// Edges bent inward by less count as flat, rad.
constexpr double kFlat = 1e-9;

struct Triangle {
  Vec3 a, b, c;
  Vec3 normal = Vec3::Zero();
  double area = 0.0;
  bool usable = false;
};

/// An edge with what the two triangles along it make of it.
struct Ridge {
  std::uint32_t from = 0, to = 0;   ///< in the direction in which `left` runs along it
  std::size_t left = 0, right = 0;  ///< triangles
  double bend = 0.0;                ///< exterior dihedral angle, > 0 convex, rad
  bool defined = false;             ///< exactly two usable triangles, opposite directions
};

std::vector<Triangle> triangles_of(const TriangleMesh& core) {
  const double smallest = kSliver * bounds(core).diagonal();
  std::vector<Triangle> result;
  result.reserve(core.triangles.size());
  for (const auto& [i, j, k] : core.triangles) {
    Triangle t{core.vertices[i], core.vertices[j], core.vertices[k]};
    const Vec3 cross = (t.b - t.a).cross(t.c - t.a);
    const double twice_area = cross.norm();
    const double longest = std::max({(t.b - t.a).norm(), (t.c - t.b).norm(), (t.a - t.c).norm()});
    t.usable = twice_area > smallest * longest;
    if (t.usable) {
      t.normal = cross / twice_area;
      t.area = 0.5 * twice_area;
    }
    result.push_back(t);
  }
  return result;
}

double bend_angle(const Vec3& direction, const Vec3& left, const Vec3& right) {
  return std::atan2(direction.dot(left.cross(right)), left.dot(right));
}

std::vector<Ridge> ridges_of(const TriangleMesh& core, const std::vector<Triangle>& triangles) {
  std::vector<Ridge> ridges;
  const std::vector<HalfEdge> sides = sorted_half_edges(core);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    Ridge ridge;
    ridge.from = edge[0].low;
    ridge.to = edge[0].high;
    if (edge.size() == 2 && edge[0].is_forward != edge[1].is_forward) {
      const std::size_t left = edge[0].is_forward ? 0 : 1;
      ridge.left = edge[left].triangle;
      ridge.right = edge[1 - left].triangle;
      ridge.defined = triangles[ridge.left].usable && triangles[ridge.right].usable;
    }
    if (ridge.defined) {
      const Vec3 direction = (core.vertices[ridge.to] - core.vertices[ridge.from]).normalized();
      ridge.bend =
          bend_angle(direction, triangles[ridge.left].normal, triangles[ridge.right].normal);
    }
    ridges.push_back(ridge);
  });
  return ridges;
}

Bounds ball_box(const Vec3& centre, double radius) {
  Bounds box;
  box.include(centre - Vec3::Constant(radius));
  box.include(centre + Vec3::Constant(radius));
  return box;
}

void add_prism(OffsetLayer& skin, const Triangle& t) {
  const double r = skin.radius;
  const Vec3& n = t.normal;
  OffsetPiece piece;
  const double height = n.dot(t.a);
  piece.planes.push_back({-n, -height});
  piece.planes.push_back({n, height + r});
  const std::array<Vec3, 3> corners = {t.a, t.b, t.c};
  for (int i = 0; i < 3; ++i) {
    const Vec3 outward = (corners[(i + 1) % 3] - corners[i]).cross(n).normalized();
    piece.planes.push_back({outward, outward.dot(corners[i])});
    piece.box.include(corners[i]);
    piece.box.include(corners[i] + r * n);
  }
  skin.pieces.push_back(std::move(piece));

  const Vec3 middle = (t.a + t.b + t.c) / 3.0;
  const Mat3 face = (t.area / 12.0) * (t.a * t.a.transpose() + t.b * t.b.transpose() +
                                       t.c * t.c.transpose() + 9.0 * middle * middle.transpose());
  SolidMoments moments;
  moments.volume = t.area * r;
  moments.first = t.area * r * (middle + 0.5 * r * n);
  moments.second = r * face +
                   (0.5 * t.area * r * r) * (middle * n.transpose() + n * middle.transpose()) +
                   (t.area * r * r * r / 3.0) * n * n.transpose();
  skin.piece_moments += moments;
  skin.area += t.area;
}

/// Sector of a cylinder from p to q, `angle` wide about the direction `w`.
SolidMoments wedge_moments(const Vec3& p, const Vec3& q, const Vec3& w, double angle, double r) {
  const double length = (q - p).norm();
  const Vec3 t = (q - p) / length;
  const Vec3 m = 0.5 * (p + q);
  const Vec3 y = t.cross(w);
  const double s = std::sin(0.5 * angle);
  SolidMoments result;
  result.volume = 0.5 * length * angle * r * r;
  const double lever = (2.0 / 3.0) * length * r * r * r * s;
  result.first = result.volume * m + lever * w;
  result.second =
      (0.5 * r * r * angle) *
          (length * m * m.transpose() + (length * length * length / 12.0) * t * t.transpose()) +
      lever * (m * w.transpose() + w * m.transpose()) +
      (0.25 * length * r * r * r * r) * (0.5 * (angle + std::sin(angle)) * w * w.transpose() +
                                         0.5 * (angle - std::sin(angle)) * y * y.transpose());
  return result;
}

OffsetPiece cylinder_piece(const Vec3& p, const Vec3& q) {
  OffsetPiece piece;
  piece.curved_face = OffsetPiece::CurvedFace::cylinder;
  piece.centre = p;
  piece.axis = (q - p).normalized();
  piece.planes.push_back({-piece.axis, -piece.axis.dot(p)});
  piece.planes.push_back({piece.axis, piece.axis.dot(q)});
  return piece;
}

void add_wedge(OffsetLayer& skin, const Vec3& p, const Vec3& q, const Vec3& left, const Vec3& right,
               double bend) {
  const double r = skin.radius;
  OffsetPiece piece = cylinder_piece(p, q);
  const Vec3 from_left = piece.axis.cross(left);
  const Vec3 from_right = -piece.axis.cross(right);
  piece.planes.push_back({-from_left, -from_left.dot(p)});
  piece.planes.push_back({-from_right, -from_right.dot(p)});
  const Vec3 w = (left + right).normalized();
  const double reach = r / std::max(std::cos(0.5 * bend), 0.5);
  for (const Vec3& end : {p, q}) {
    piece.box.include(end);
    piece.box.include(end + r * left);
    piece.box.include(end + r * right);
    // The corner where the tangents at both ends of the arc meet; beyond 120 degrees the arc is
    // enclosed by a square.
    piece.box.include(end + reach * w);
    if (bend > 2.0 * kPi / 3.0) {
      piece.box.include(end + Vec3::Constant(r));
      piece.box.include(end - Vec3::Constant(r));
    }
  }
  skin.pieces.push_back(std::move(piece));
  skin.piece_moments += wedge_moments(p, q, w, bend, r);
  skin.area += (q - p).norm() * bend * r;
}

/// If the adjacent triangles do not define the outer side of an edge, the whole cylinder is used.
void add_cylinder(OffsetLayer& skin, const Vec3& p, const Vec3& q) {
  const double length = (q - p).norm();
  if (!(length > 0.0)) return;
  OffsetPiece piece = cylinder_piece(p, q);
  piece.box = ball_box(p, skin.radius);
  piece.box.include(q + Vec3::Constant(skin.radius));
  piece.box.include(q - Vec3::Constant(skin.radius));
  const Vec3 w = piece.axis.unitOrthogonal();
  skin.pieces.push_back(std::move(piece));
  skin.piece_moments += wedge_moments(p, q, w, 2.0 * kPi, skin.radius);
  skin.area += 2.0 * kPi * length * skin.radius;
}

double height_over(const Triangle& t, const Vec3& p, const Vec3& q) {
  return 2.0 * t.area / (q - p).norm();
}

/// The prism over the kite in which two face prisms overlap at a reflex edge.
void add_overlap(OffsetLayer& skin, const Vec3& p, const Vec3& q, const Triangle& left,
                 const Triangle& right, double bend, double clear_radius) {
  const double r = skin.radius;
  const double slope = std::tan(0.5 * std::abs(bend));
  const double room = std::min(height_over(left, p, q), height_over(right, p, q));
  const Vec3& n1 = left.normal;
  const Vec3& n2 = right.normal;
  const double together = 1.0 + n1.dot(n2);  // 0 where both lie face to face
  if (!(clear_radius * slope <= room) || !(together > 0.0)) return;

  OffsetPiece piece = cylinder_piece(p, q);
  piece.curved_face = OffsetPiece::CurvedFace::none;
  const Vec3 into_left = n1.cross(piece.axis);
  const Vec3 into_right = -n2.cross(piece.axis);
  piece.planes.push_back({n1, n1.dot(p) + r});
  piece.planes.push_back({n2, n2.dot(p) + r});
  piece.planes.push_back({-into_left, -into_left.dot(p)});
  piece.planes.push_back({-into_right, -into_right.dot(p)});

  const std::array<Vec3, 4> kite = {Vec3::Zero(), r * n1, (r / together) * (n1 + n2), r * n2};
  TriangleMesh prism;
  for (const Vec3& end : {p, q}) {
    for (const Vec3& corner : kite) {
      prism.vertices.push_back(end + corner);
      piece.box.include(end + corner);
    }
  }
  prism.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    prism.triangles.push_back({i, i + 4, j + 4});
    prism.triangles.push_back({i, j + 4, j});
  }
  const SolidMoments moments = polyhedron_moments(prism, Vec3::Zero());
  skin.overlap_moments.add_scaled(moments, moments.volume < 0.0 ? -1.0 : 1.0);
  skin.overlap_area += 2.0 * r * slope * (q - p).norm();
  skin.overlaps.push_back(std::move(piece));
}

/// The edges that leave a vertex.
struct Fan {
  std::vector<Vec3> directions;
  std::vector<double> bends;
  bool defined = true;
};

void add_corner(OffsetLayer& skin, const Vec3& v, const Fan& fan) {
  const double r = skin.radius;
  NormalConeIntegrals cone;
  if (fan.defined) {
    cone = integrate_normal_cone(fan.directions, fan.bends);
    if (!(cone.solid_angle > 0.0)) return;
  } else {
    cone.solid_angle = 4.0 * kPi;
    cone.second = (4.0 * kPi / 3.0) * Mat3::Identity();
  }
  OffsetPiece piece;
  piece.curved_face = OffsetPiece::CurvedFace::sphere;
  piece.centre = v;
  piece.box = ball_box(v, r);
  if (fan.defined) {
    for (const Vec3& direction : fan.directions) {
      piece.planes.push_back({direction, direction.dot(v)});
    }
  }
  skin.pieces.push_back(std::move(piece));

  const double r4 = r * r * r * r;
  SolidMoments moments;
  moments.volume = cone.solid_angle * r * r * r / 3.0;
  moments.first = moments.volume * v + (0.25 * r4) * cone.first;
  moments.second = moments.volume * v * v.transpose() +
                   (0.25 * r4) * (v * cone.first.transpose() + cone.first * v.transpose()) +
                   (0.2 * r4 * r) * cone.second;
  skin.piece_moments += moments;
  skin.area += cone.solid_angle * r * r;
  skin.solid_angle += cone.solid_angle;
}

}  // namespace

OffsetLayer decompose_offset_layer(const TriangleMesh& core, double radius, double clear_radius) {
  OffsetLayer skin;
  skin.radius = radius;
  const std::vector<Triangle> triangles = triangles_of(core);
  const std::vector<Ridge> ridges = ridges_of(core, triangles);
  for (const Triangle& t : triangles) {
    if (t.usable) add_prism(skin, t);
  }

  std::vector<Fan> fans(core.vertices.size());
  for (const Ridge& ridge : ridges) {
    const Vec3& p = core.vertices[ridge.from];
    const Vec3& q = core.vertices[ridge.to];
    const Vec3 direction = (q - p).normalized();
    for (const auto end : {ridge.from, ridge.to}) {
      Fan& fan = fans[end];
      fan.directions.push_back(end == ridge.from ? direction : Vec3(-direction));
      fan.bends.push_back(ridge.bend);
      fan.defined = fan.defined && ridge.defined;
    }
    if (!ridge.defined) {
      add_cylinder(skin, p, q);
      skin.has_reflex_edge = true;
      continue;
    }
    const Triangle& left = triangles[ridge.left];
    const Triangle& right = triangles[ridge.right];
    if (ridge.bend > 0.0) add_wedge(skin, p, q, left.normal, right.normal, ridge.bend);
    if (ridge.bend < 0.0) add_overlap(skin, p, q, left, right, ridge.bend, clear_radius);
    if (ridge.bend < -kFlat) skin.has_reflex_edge = true;
  }
  for (std::size_t v = 0; v < fans.size(); ++v) {
    if (!fans[v].directions.empty()) add_corner(skin, core.vertices[v], fans[v]);
  }
  return skin;
}

}  // namespace clast::massprops_detail

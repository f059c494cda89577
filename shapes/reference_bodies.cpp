#include "shapes/reference_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "shapes/convex_cell.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {
namespace {

constexpr int kAround = 32;         ///< corners of a cylinder's end
constexpr int kSphereHalvings = 2;  ///< of the edges of an icosahedron: 162 corners
constexpr double kMaxFraction = 0.4;

const std::array<std::pair<ReferenceShape, const char*>, 7> kForms = {
    {{ReferenceShape::kSphere, "sphere"},
     {ReferenceShape::kBox, "box"},
     {ReferenceShape::kEllipsoid, "ellipsoid"},
     {ReferenceShape::kSuperellipsoid, "superellipsoid"},
     {ReferenceShape::kCylinder, "cylinder"},
     {ReferenceShape::kEota111, "eota-111"},
     {ReferenceShape::kEota221, "eota-221"}}};

/// Corners of an icosahedron whose edges are halved and put on the unit sphere. It is its own
/// mirror image in the three planes of the axes.
std::vector<Vec3> sphere_points() {
  const double t = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Vec3> points;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-t, t}) {
      points.emplace_back(Vec3(0.0, a, b).normalized());
      points.emplace_back(Vec3(a, b, 0.0).normalized());
      points.emplace_back(Vec3(b, 0.0, a).normalized());
    }
  }
  for (int i = 0; i < kSphereHalvings; ++i) {
    const TriangleMesh hull = convex_hull(points);
    points = hull.vertices;
    for_each_edge(sorted_half_edges(hull), [&](std::span<const HalfEdge> sides) {
      const Vec3 middle = hull.vertices[sides[0].low] + hull.vertices[sides[0].high];
      points.push_back(middle.normalized());
    });
  }
  return points;
}

std::vector<Vec3> superellipsoid_points(double exponent) {
  std::vector<Vec3> points = sphere_points();
  for (Vec3& p : points) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += std::pow(std::abs(p[k]), exponent);
    p *= std::pow(sum, -1.0 / exponent);
  }
  return points;
}

std::vector<Vec3> cylinder_points(const BoxRatios& ratios) {
  // If S/I is nearer to 1 than I/L (rod), the axis of symmetry is L; otherwise (plate) it is S.
  const int axis = ratios.i_l * ratios.i_l < ratios.s_l ? 0 : 2;
  std::vector<Vec3> points;
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2.0 * kPi * i / kAround;
    for (const double end : {-1.0, 1.0}) {
      Vec3 p;
      p[axis] = end;
      p[(axis + 1) % 3] = std::cos(angle);
      p[(axis + 2) % 3] = std::sin(angle);
      points.push_back(p);
    }
  }
  return points;
}

/// A cube from -1 to 1 with every edge cut a quarter of the width off, along both its faces.
std::vector<Vec3> cut_cube_points() {
  std::vector<Vec3> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 8; ++i) {
      Vec3 p(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
      p[axis] *= 2.0;
      points.push_back(p);
    }
  }
  return points;
}

std::vector<Vec3> cube_points() {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
  }
  return points;
}

/// Between -1 and 1 along each axis.
std::vector<Vec3> points_of(ReferenceShape form, const ReferenceBodyOptions& options) {
  switch (form) {
    case ReferenceShape::kSphere:
      break;
    case ReferenceShape::kBox:
      return cube_points();
    case ReferenceShape::kEllipsoid:
      return sphere_points();
    case ReferenceShape::kSuperellipsoid:
      return superellipsoid_points(options.exponent);
    case ReferenceShape::kCylinder:
      return cylinder_points(options.ratios);
    case ReferenceShape::kEota111:
    case ReferenceShape::kEota221:
      return cut_cube_points();
  }
  return {Vec3::Zero()};
}

}  // namespace

const std::vector<std::string>& reference_shape_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [form, name] : kForms) all.emplace_back(name);
    return all;
  }();
  return names;
}

std::string name_of(ReferenceShape form) {
  for (const auto& [known, name] : kForms) {
    if (known == form) return name;
  }
  return {};
}

ReferenceShape parse_reference_shape(const std::string& name) {
  std::string known;
  for (const auto& [form, text] : kForms) {
    if (name == text) return form;
    known += (known.empty() ? "" : ", ") + std::string(text);
  }
  throw InputError("no reference body is called \"" + name + "\"; there are " + known);
}

void ReferenceBodyOptions::check() const {
  ratios.check();
  if (!(radius_fraction >= 0.0 && radius_fraction <= kMaxFraction)) {
    throw InputError("the radius as a fraction of S is " + format_significant(radius_fraction, 4) +
                     "; it must be between 0 and " + format_significant(kMaxFraction, 2));
  }
  if (!(exponent >= 1.0 && exponent <= 20.0)) {
    throw InputError("`exponent` = " + format_significant(exponent, 4) + ": must be from 1 to 20");
  }
}

SpheroPolyhedron make_reference_body(ReferenceShape form, const ReferenceBodyOptions& options) {
  options.check();
  if (form == ReferenceShape::kSphere) {
    SpheroPolyhedron ball;
    ball.vertices = {Vec3::Zero()};
    ball.radius = 0.5;
    return ball;
  }
  const bool own_ratios = form == ReferenceShape::kEota111 || form == ReferenceShape::kEota221;
  BoxRatios ratios = options.ratios;
  if (own_ratios) ratios = {1.0, form == ReferenceShape::kEota111 ? 1.0 : 0.5};
  std::vector<Vec3> points = points_of(form, options);
  for (Vec3& p : points) p = 0.5 * p.cwiseProduct(Vec3(1.0, ratios.i_l, ratios.s_l));
  const double radius = options.radius_fraction * ratios.s_l;
  std::optional<SpheroPolyhedron> body = inscribed_rounded_body(convex_hull(points), radius);
  if (!body) {
    throw GeometryError("rounded with " + format_significant(options.radius_fraction, 4) +
                        " of S, no core is left of the " + name_of(form) +
                        "; give a smaller radius");
  }
  // Corners that were rounded inwards reach less far than they did.
  SpheroPolyhedron fitted = stretch_to_ratios(*body, ratios).body;
  return scaled(fitted, 1.0 / smallest_box(fitted).lengths[0]);
}

}  // namespace clast

// An outcome over the triangle of Sneed and Folk.
#include "report/charts/response_triangle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>
#include <sstream>
#include <vector>

#include "report/charts/contour_field.hpp"
#include "tests/support/refusal.hpp"

namespace clast::report_detail {
namespace {

TEST(ResponseTriangle, PutsFormsAtTheirCornersAndColoursThemByTheirValue) {
  const std::vector<ShapeResponse> forms = {{"cube <1>", {1.0, 1.0, 1.0}, 60.0},
                                            {"disc", {1.0, 1.0, 1e-9}, 20.0},
                                            {"rod", {1.0, 1e-9, 1e-9}, 30.0, true}};
  const std::string svg = draw_response_triangle(forms, "mean runout, m");
  // Corners of an equilateral triangle of side 520 px: 450.3 px high.
  EXPECT_TRUE(contains(svg, "<circle cx=\"310.0\" cy=\"40.0\" r=\"3.5\" fill=\"#253494\""));
  EXPECT_TRUE(contains(svg, "<circle cx=\"50.0\" cy=\"490.3\" r=\"3.5\" fill=\"#ffffcc\""));
  EXPECT_TRUE(contains(svg, "<circle cx=\"570.0\" cy=\"490.3\" r=\"6.0\" fill=\"#a1dab4\""));
  EXPECT_TRUE(contains(svg, "<title>cube &lt;1&gt;: 60.0, mean runout, m</title>"));
  EXPECT_TRUE(contains(svg, "clip-path")) << "there is a surface, with lines at 25, 30, ...";
  EXPECT_TRUE(contains(svg, ">55"));
  // All alike: nothing to divide by, and no surface.
  const std::string one = draw_response_triangle({forms.data(), 1}, "m");
  EXPECT_TRUE(contains(one, "fill=\"#ffffcc\""));
  EXPECT_FALSE(contains(one, "clip-path"));
}

// Values rise steeply along the lower side, where many lines end next to each other.
TEST(ResponseTriangle, ValuesOfLinesDoNotCoverEachOther) {
  std::vector<ShapeResponse> forms;
  for (int i = 0; i <= 8; ++i) {
    for (int k = 0; k <= i; ++k) {
      const double s = 1.0 - 0.1 * i, elongation = i == 0 ? 0.0 : k / static_cast<double>(i);
      const double middle = 1.0 - elongation * (1.0 - s);
      forms.push_back({"f", {1.0, middle, s}, 20.0 + 60.0 * s + 50.0 * std::pow(elongation, 12)});
    }
  }
  const std::string svg = draw_response_triangle(forms, "m");
  std::vector<Vec2> places;
  const std::string mark = "text-anchor=\"end\" font-size=\"11\"";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1)) {
    const std::size_t begin = svg.rfind("<text x=\"", at);
    double x = 0.0, y = 0.0;
    ASSERT_EQ(std::sscanf(svg.c_str() + begin, "<text x=\"%lf\" y=\"%lf\"", &x, &y), 2);
    places.emplace_back(x, y);
  }
  EXPECT_GE(places.size(), 5u);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Vec2 apart = (places[i] - places[k]).cwiseAbs();
      EXPECT_TRUE(apart.x() >= 31.9 || apart.y() >= 13.9) << places[i].transpose();
    }
  }
}

// A plate through values of a plane is the plane.
TEST(ContourField, OfAPlaneIsFlatWithStraightLines) {
  const std::vector<Vec2> places = {{0, 0}, {100, 0}, {0, 100}, {100, 100}, {30, 60}};
  std::vector<double> values;
  for (const Vec2& place : places) values.push_back(5.0 + 0.1 * place.x());
  const ThinPlateSpline plate(places, values);
  EXPECT_NEAR(plate.value_at({50, 20}), 10.0, 1e-9);
  const std::vector<Vec2> hull = plan_convex_hull(places);
  EXPECT_EQ(hull.size(), 4u) << "the fifth is inside";
  EXPECT_TRUE(is_inside(hull, {50, 50}));
  EXPECT_FALSE(is_inside(hull, {101, 50}));
  const ContourLine line = trace_contour_line(plate, hull, 10.0, 7.0);
  ASSERT_FALSE(line.pieces.empty());
  double length = 0.0;
  for (const auto& [from, to] : line.pieces) {
    EXPECT_NEAR(from.x(), 50.0, 1e-6);
    length += (to - from).norm();
  }
  EXPECT_GT(length, 95.0);
  EXPECT_LT(length, 125.0) << "a triangle beyond either side at most";
  EXPECT_TRUE(trace_contour_line(plate, hull, 16.0, 7.0).pieces.empty());
}

/// Areas of the closed parts of a path, px^2.
std::vector<double> areas_of(const std::string& path) {
  std::vector<double> areas;
  std::vector<Vec2> part;
  std::istringstream text(path);
  for (char step; text >> step;) {
    if (step != 'Z') {
      Vec2& place = part.emplace_back();
      text >> place.x() >> place.y();
      continue;
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vec2 &a = part[i], &b = part[(i + 1) % part.size()];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    areas.push_back(0.5 * std::abs(twice));
    part.clear();
  }
  return areas;
}

// Triangles that lie wholly in a band are drawn row by row, not one by one.
TEST(ContourField, BandsHaveTheirAreaInFewParts) {
  const std::vector<Vec2> places = {{0, 0}, {100, 0}, {0, 100}, {100, 100}};
  const std::vector<double> values = {0.0, 10.0, 0.0, 10.0};
  const ThinPlateSpline plate(places, values);
  const std::vector<Vec2> hull = plan_convex_hull(places);
  for (const double level : {-5.0, 2.0, 5.0, 9.0}) {
    const double width = std::min(100.0, 100.0 - 10.0 * level);
    const std::vector<double> areas = areas_of(format_band_path(plate, hull, level, 5.0));
    const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
    EXPECT_GT(area, 98.0 * width) << level;
    EXPECT_LT(area, (width + 10.0) * 112.0) << level;
    EXPECT_LT(areas.size(), level < 0.0 ? 30u : 110u) << level;
  }
}

TEST(ContourField, PassesThroughItsValues) {
  const std::vector<Vec2> places = {{0, 0}, {80, 5}, {10, 90}, {60, 60}, {30, 40}};
  const std::vector<double> values = {1.0, 4.0, -2.0, 7.0, 0.5};
  const ThinPlateSpline plate(places, values);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(plate.value_at(places[i]), values[i], 1e-9);
  }
}

}  // namespace
}  // namespace clast::report_detail

// An outcome over the triangle of Sneed and Folk.
#include "report/charts/response_triangle.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/refusal.hpp"

namespace clast::report_detail {
namespace {

TEST(ResponseTriangle, PutsFormsAtTheirCornersAndColoursThemByTheirValue) {
  const std::vector<FormResponse> forms = {{"cube <1>", {1.0, 1.0, 1.0}, 60.0},
                                           {"disc", {1.0, 1.0, 1e-9}, 20.0},
                                           {"rod", {1.0, 1e-9, 1e-9}, 30.0}};
  const std::string svg = response_triangle(forms, "mean runout, m");
  // Corners of an equilateral triangle of side 520 px: 450.3 px high.
  EXPECT_TRUE(contains(svg, "<circle cx=\"310.0\" cy=\"40.0\" r=\"19.2\" fill=\"#253494\""));
  EXPECT_TRUE(contains(svg, "<circle cx=\"50.0\" cy=\"490.3\" r=\"19.2\" fill=\"#ffffcc\""));
  EXPECT_TRUE(contains(svg, "<circle cx=\"570.0\" cy=\"490.3\" r=\"19.2\" fill=\"#a1dab4\""));
  EXPECT_TRUE(contains(svg, "<title>cube &lt;1&gt;: 60.0, mean runout, m</title>"));
  // All alike: nothing to divide by.
  EXPECT_TRUE(contains(response_triangle({forms.data(), 1}, "m"), "fill=\"#ffffcc\""));
}

}  // namespace
}  // namespace clast::report_detail

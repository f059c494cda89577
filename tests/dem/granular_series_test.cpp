// A series of columns against published experiments (docs/benchmarks.md, Columns of blocks).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "tests/support/granular_column.hpp"

namespace clast {
namespace {

void print(const ColumnScene& scene, const Collapse& collapse) {
  const double law = published_runout(collapse.aspect());
  std::printf("%zu blocks, seed %llu: r0 %.2f m, a %.2f, runout %.3f, law %.3f; overlap %.3f m\n",
              scene.blocks, static_cast<unsigned long long>(scene.seed), collapse.radius,
              collapse.aspect(), collapse.runout(), law, collapse.touching);
  std::fflush(stdout);
}

/// r - r0 = s F r0 - c d: s and c by least squares, with standard errors.
struct FrontFit {
  double scale = 0.0, scale_error = 0.0;
  double diameters = 0.0, diameters_error = 0.0;
};
FrontFit fit_front(const std::vector<Collapse>& collapses) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Collapse& collapse : collapses) {
    const double law = published_runout(collapse.aspect()) * collapse.radius;
    const double run = collapse.front - collapse.radius;
    n += 1.0;
    x += law;
    y += run;
    xx += law * law;
    xy += law * run;
  }
  const double spread = xx - x * x / n;
  FrontFit fit;
  fit.scale = (xy - x * y / n) / spread;
  fit.diameters = (fit.scale * x - y) / n;
  double squares = 0.0;
  for (const Collapse& collapse : collapses) {
    const double law = published_runout(collapse.aspect()) * collapse.radius;
    const double off = collapse.front - collapse.radius - fit.scale * law + fit.diameters;
    squares += off * off;
  }
  fit.scale_error = std::sqrt(squares / (n - 2.0) / spread);
  fit.diameters_error = fit.scale_error * std::sqrt(xx / n);
  return fit;
}

// The law holds for grains that are fine against r0. Blocks end c diameters short of it
// (docs/theory.md, Columns): s and c come from columns of different sizes and heights
// together, and s must be 1.
TEST(GranularColumns, RunOutAsPublishedLessAFrontOfTheThicknessOfABlock) {
  constexpr double kBar = 0.15;
  const std::vector<ColumnScene> scenes = {{.aspect = 0.6, .blocks = 150},
                                           {.aspect = 1.0, .blocks = 50},
                                           {.aspect = 1.0, .blocks = 50, .seed = 2},
                                           {.aspect = 1.0, .blocks = 50, .seed = 3},
                                           {.aspect = 1.0, .blocks = 100},
                                           {.aspect = 1.0, .blocks = 100, .seed = 2},
                                           {.aspect = 1.0, .blocks = 250},
                                           {.aspect = 1.0, .blocks = 600},
                                           {.aspect = 2.0, .blocks = 200},
                                           {.aspect = 4.0, .blocks = 150},
                                           {.aspect = 6.0, .blocks = 150}};
  std::vector<Collapse> collapses;
  for (const ColumnScene& scene : scenes) {
    collapses.push_back(collapse_column(scene));
    print(scene, collapses.back());
    EXPECT_LT(collapses.back().energy_error, 1e-4);
  }
  const FrontFit fit = fit_front(collapses);
  std::printf("r - r0 = (%.2f +- %.2f) F r0 - (%.1f +- %.1f) d\n", fit.scale, fit.scale_error,
              fit.diameters, fit.diameters_error);
  EXPECT_NEAR(fit.scale, 1.0, kBar);
  EXPECT_LT(fit.scale_error, kBar);
  for (const Collapse& collapse : collapses) {
    const double law = published_runout(collapse.aspect());
    const double fine = collapse.runout() + fit.diameters / collapse.radius;
    std::printf("a %.2f: with the front %.3f, law %.3f, %+.1f %%\n", collapse.aspect(), fine, law,
                100.0 * (fine / law - 1.0));
    EXPECT_NEAR(fine, law, kBar * law) << collapse.aspect();
  }
}

}  // namespace
}  // namespace clast

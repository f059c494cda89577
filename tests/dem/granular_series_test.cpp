// A series of columns against published experiments (docs/accuracy.md, Columns of blocks).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "tests/support/granular_column.hpp"

namespace clast {
namespace {

/// Columns of one kind that are filled otherwise: two of them differ by a tenth in their run-out.
struct Series {
  ColumnScene scene;
  std::uint64_t columns = 1;
};

/// What they do on average.
Collapse mean_of(const Series& series) {
  Collapse mean;
  double squares = 0.0;
  const auto n = static_cast<double>(series.columns);
  for (std::uint64_t seed = 1; seed <= series.columns; ++seed) {
    ColumnScene scene = series.scene;
    scene.seed = seed;
    const Collapse collapse = collapse_column(scene);
    EXPECT_LT(collapse.energy_error, 1e-4);
    mean.radius += collapse.radius / n;
    mean.height += collapse.height / n;
    mean.front += collapse.front / n;
    mean.touching = std::max(mean.touching, collapse.touching);
    squares += collapse.runout() * collapse.runout() / n;
  }
  const double variance = std::max(0.0, squares - mean.runout() * mean.runout());
  std::printf("%zu blocks, %.0f columns: r0 %.2f m, a %.2f, runout %.3f +- %.3f, law %.3f\n",
              series.scene.blocks, n, mean.radius, mean.aspect(), mean.runout(),
              n > 1.0 ? std::sqrt(variance / (n - 1.0)) : 0.0, published_runout(mean.aspect()));
  std::fflush(stdout);
  return mean;
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

/// What columns higher than their radius are short of the law, in diameters, mean over all.
double missing_front(const std::vector<Collapse>& collapses) {
  double sum = 0.0, n = 0.0;
  for (const Collapse& collapse : collapses) {
    if (collapse.aspect() < 1.0) continue;
    sum +=
        published_runout(collapse.aspect()) * collapse.radius - (collapse.front - collapse.radius);
    n += 1.0;
  }
  return sum / n;
}

// The law holds for grains that are fine against r0. Blocks end c diameters short of it
// (docs/theory.md, Columns): s and c come from columns of different sizes and heights
// together, and s must be within 15 % of 1, as well as it is known. Flat columns have a shorter
// front than others.
TEST(GranularColumns, RunOutAsPublishedLessAFrontOfTheThicknessOfABlock) {
  constexpr double kBar = 0.15;
  const std::vector<Series> all = {
      {{.aspect = 0.6, .blocks = 150}, 3}, {{.aspect = 1.0, .blocks = 50}, 8},
      {{.aspect = 1.0, .blocks = 100}, 6}, {{.aspect = 1.0, .blocks = 250}, 3},
      {{.aspect = 1.0, .blocks = 600}, 1}, {{.aspect = 2.0, .blocks = 200}, 4},
      {{.aspect = 4.0, .blocks = 150}, 4}, {{.aspect = 6.0, .blocks = 150}, 4}};
  std::vector<Collapse> collapses;
  for (const Series& series : all) collapses.push_back(mean_of(series));
  const FrontFit fit = fit_front(collapses);
  std::printf("r - r0 = (%.2f +- %.2f) F r0 - (%.1f +- %.1f) d\n", fit.scale, fit.scale_error,
              fit.diameters, fit.diameters_error);
  EXPECT_NEAR(fit.scale, 1.0, kBar + 2.0 * fit.scale_error);
  EXPECT_LT(fit.scale_error, kBar);
  const double missing = missing_front(collapses);
  std::printf("with s = 1 and a > 1: %.1f d\n", missing);
  for (const Collapse& collapse : collapses) {
    const double law = published_runout(collapse.aspect());
    const double fine = collapse.runout() + missing / collapse.radius;
    std::printf("a %.2f: with the front %.3f, law %.3f, %+.1f %%\n", collapse.aspect(), fine, law,
                100.0 * (fine / law - 1.0));
    if (collapse.aspect() > 1.0) {
      EXPECT_NEAR(fine, law, kBar * law) << collapse.aspect();
    }
  }
}

}  // namespace
}  // namespace clast

// Calibrations of fifty known truths: how often intervals have them.
#include <gtest/gtest.h>

#include "tests/study/calibrate/made_up_site.hpp"

namespace clast {
namespace {

/// What fifty studies of truths drawn from the prior came to.
struct Fifty {
  std::size_t intervals = 0, covering = 0, failed_fits = 0, failed_kept = 0;
  std::size_t kept_figures = 0, kept_covered = 0;
};

/// @param bend  what the field has beyond the law of the simulations, m
Fifty fifty_studies(double bend) {
  Fifty fifty;
  Random truths(20220310);
  for (std::uint64_t study = 1; study <= 50; ++study) {
    MadeUpStudy made(32, 64, study);
    MadeUpSite first, second;
    first.seed = study;
    second.seed = 1000 + study;
    second.reach = 1.3;
    const std::size_t fit = made.add_site("first", first), keep = made.add_site("second", second);
    std::vector<double> truth;
    for (const UnknownParameter& unknown : made.study.unknowns)
      truth.push_back(unknown.prior_quantile(truths.uniform()));
    first.bend = second.bend = bend;  // of the field alone
    made.observe(fit, first, truth, 24, true, 7 * study);
    made.observe(keep, second, truth, 24, false, 11 * study);
    const CalibrationPosterior posterior = made.posterior();
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ++fifty.intervals;
      if (covers(posterior.marginals[i], truth[i])) ++fifty.covering;
    }
    if (posterior.fitted.failed()) ++fifty.failed_fits;
    if (posterior.held_out.failed()) ++fifty.failed_kept;
    fifty.kept_figures += posterior.held_out.statistics;
    fifty.kept_covered += posterior.held_out.covered;
  }
  return fifty;
}

TEST(CalibrationCoverage, IntervalsHaveTheTruthAsOftenAsTheySay) {
  const Fifty fifty = fifty_studies(0.0);
  const double share = static_cast<double>(fifty.covering) / static_cast<double>(fifty.intervals);
  EXPECT_GE(share, 0.90);
  EXPECT_LE(share, 0.99);
  const double kept =
      static_cast<double>(fifty.kept_covered) / static_cast<double>(fifty.kept_figures);
  EXPECT_GE(kept, 0.90);
  // One in twenty fails by chance; eight or more of fifty have a probability below 0.01.
  EXPECT_LT(fifty.failed_fits, 8u);
  EXPECT_LT(fifty.failed_kept, 8u);
}

// Six single impacts each, nothing else.
TEST(CalibrationCoverage, IntervalsFromImpactsAloneHaveTheTruth) {
  Random truths(4711);
  std::size_t intervals = 0, covering = 0, failed = 0;
  for (std::uint64_t study = 1; study <= 50; ++study) {
    MadeUpStudy made(32, 60, study);
    const std::size_t throws = made.add_throws();
    std::vector<double> truth;
    for (const UnknownParameter& unknown : made.study.unknowns) {
      truth.push_back(unknown.prior_quantile(truths.uniform()));
    }
    made.observe_throws(throws, {}, truth, 5 * study);
    const CalibrationPosterior posterior = made.posterior();
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ++intervals;
      if (covers(posterior.marginals[i], truth[i])) ++covering;
    }
    if (posterior.fitted.failed()) ++failed;
  }
  const double share = static_cast<double>(covering) / static_cast<double>(intervals);
  EXPECT_GE(share, 0.90);
  EXPECT_LE(share, 0.99);
  // With the variance of a bootstrap as it is, 9 of the 50 failed.
  EXPECT_LT(failed, 8u);
}

TEST(CalibrationCoverage, AWrongLawIsNoticed) {
  const Fifty fifty = fifty_studies(6.0);
  EXPECT_GE(fifty.failed_fits, 45u);
}

}  // namespace
}  // namespace clast

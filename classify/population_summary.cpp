#include "classify/population_summary.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "core/statistics/statistics.hpp"

namespace clast {
namespace {

void check_has_blocks(const Population& population) {
  if (population.blocks.empty()) {
    throw InputError("population " + population.name + ": has no blocks to describe");
  }
}

SizeShapeCorrelation size_shape(const Population& population, const ShapeMeasure& measure,
                                SizeMeasure size) {
  std::vector<double> sizes, shapes;
  for (const MeasuredBlock& block : population.blocks) {
    const auto shape = measure.value(block.axes_in_table_unit);
    if (!shape || block.unscaled) continue;
    // Relative to a metre the twelfth decimal is far below any tape or scanner.
    sizes.push_back(round_ratio(block_size(block.axes, size)));
    shapes.push_back(round_ratio(*shape));
  }
  return {&measure, sizes.size(), spearman_test(sizes, shapes)};
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? std::nan("") : quantile(values, 0.5);
}

std::string chance(double p) {
  return "two samples of one deposit differ by this much or more with a probability of " +
         format_p_value(p);
}

ShapeMeasureDifference measure_difference(const ShapeMeasure& measure, const Population& a,
                                          const std::vector<Axes>& axes_a, const Population& b,
                                          const std::vector<Axes>& axes_b) {
  const std::vector<double> x = measure_values(measure, axes_a),
                            y = measure_values(measure, axes_b);
  ShapeMeasureDifference result{&measure, median_of(x), median_of(y), two_sample_ks_test(x, y), {}};
  const std::string name = std::string(measure.name) + " = " + measure.formula;
  if (!result.test) {
    result.description = name + " is not defined for the blocks of one of the two populations.";
    return result;
  }
  const bool differs = result.test->p_value < kSignificanceLevel;
  result.description =
      (differs ? "The distributions of " + name + " differ"
               : "No difference in " + name + " can be shown") +
      ": median " + format_decimals(result.median_a, 3) + " in " + a.name + " (" +
      std::to_string(x.size()) + " blocks), " + format_decimals(result.median_b, 3) + " in " +
      b.name + " (" + std::to_string(y.size()) + "); " + chance(result.test->p_value) +
      " (Kolmogorov-Smirnov, D = " + format_decimals(result.test->statistic, 3) + ").";
  return result;
}

/// The class whose share differs most, which is what a reader wants named.
std::string describe_largest_difference(const std::vector<ClassFraction>& a,
                                        const std::string& name_a,
                                        const std::vector<ClassFraction>& b,
                                        const std::string& name_b) {
  std::size_t largest = 0;
  const auto gap = [&](std::size_t k) { return std::abs(a[k].fraction - b[k].fraction); };
  for (std::size_t k = 1; k < a.size(); ++k) {
    if (gap(k) > gap(largest)) largest = k;
  }
  const auto share = [&](const ClassFraction& one, const std::string& name) {
    return format_percent(one.fraction) + " (" + format_percent(one.low) + " to " +
           format_percent(one.high) + ") of " + name;
  };
  return "most for " + a[largest].name + ", " + share(a[largest], name_a) + " against " +
         share(b[largest], name_b);
}

ClassFractionDifference class_difference(const std::string& scheme, const Population& a,
                                         const std::vector<Axes>& axes_a, const Population& b,
                                         const std::vector<Axes>& axes_b,
                                         const PopulationOptions& options) {
  const std::vector<ClassFraction> shares_a = class_fractions(axes_a, scheme, options.limits);
  const std::vector<ClassFraction> shares_b = class_fractions(axes_b, scheme, options.limits);
  std::vector<std::size_t> counts_a, counts_b;
  for (const ClassFraction& share : shares_a) counts_a.push_back(share.count);
  for (const ClassFraction& share : shares_b) counts_b.push_back(share.count);
  ClassFractionDifference result{scheme, chi_squared_test(counts_a, counts_b, options.seed), {}};
  if (!result.test) {
    result.description = "All blocks of both populations are of one " + scheme + " class.";
    return result;
  }
  const ChiSquaredResult& test = *result.test;
  const bool differs = test.p_value < kSignificanceLevel;
  result.description = (differs ? "The fractions of the " + scheme + " classes differ, "
                                : "No difference in the fractions of the " + scheme +
                                      " classes can be shown; they differ ") +
                       describe_largest_difference(shares_a, a.name, shares_b, b.name) + "; " +
                       chance(test.p_value) + " (chi-squared " +
                       format_decimals(test.chi_squared, 2) + ", " +
                       std::to_string(test.degrees_of_freedom) +
                       (test.degrees_of_freedom == 1 ? " degree" : " degrees") + " of freedom";
  if (test.draws > 0) {
    result.description += "; smallest expected count " +
                          format_decimals(test.smallest_expected, 1) + ", so from " +
                          std::to_string(test.draws) + " random tables";
  }
  result.description += ").";
  return result;
}

}  // namespace

const std::vector<std::string>& PopulationOptions::selected_schemes() const {
  return schemes.empty() ? scheme_names() : schemes;
}

void PopulationOptions::check() const {
  limits.check();
  for (const std::string& scheme : schemes) {
    with_error_context("`schemes`", [&] { class_names(scheme); });
    if (std::count(schemes.begin(), schemes.end(), scheme) > 1) {
      throw InputError("`schemes`: names " + scheme + " more than once");
    }
  }
}

std::string format_p_value(double p_value) {
  if (p_value < 1e-4) return "less than 0.0001";
  return format_significant(p_value, 2);
}

std::string describe_size_shape(const SizeShapeCorrelation& relation, SizeMeasure size) {
  const std::string pair = name_of(size) + " and " + relation.measure->name;
  if (!relation.test) {
    return "Whether " + pair + " are related can't be tested for " +
           std::to_string(relation.blocks) + (relation.blocks == 1 ? " block" : " blocks") +
           (relation.blocks < 3 ? "." : " of one size or one shape.");
  }
  const double rho = relation.test->statistic;
  const std::string found = relation.test->p_value >= kSignificanceLevel
                                ? "No relation of " + pair + " can be shown"
                                : std::string(relation.measure->name) +
                                      (rho > 0.0 ? " rises" : " falls") + " with size " +
                                      name_of(size);
  return found + ": Spearman's rho " + format_decimals(rho, 2) + " over " +
         std::to_string(relation.blocks) + " blocks, p " + format_p_value(relation.test->p_value) +
         ".";
}

PopulationSummary summarise_population(const Population& population,
                                       const PopulationOptions& options) {
  check_has_blocks(population);
  PopulationSummary summary;
  summary.name = population.name;
  summary.blocks = population.blocks.size();
  for (const MeasuredBlock& block : population.blocks)
    summary.blocks_with_mass += block.mass.has_value();
  const std::vector<Axes> axes = axes_for_ratios(population);
  const std::vector<double> weights = block_masses(population);
  for (const std::string& scheme : options.selected_schemes()) {
    summary.schemes.push_back({scheme, class_fractions(axes, scheme, options.limits, weights)});
  }
  summary.size = size_distribution(population, options.size, options.seed);
  for (const ShapeMeasure& measure : shape_measures()) {
    summary.size_shape_correlations.push_back(size_shape(population, measure, options.size));
  }
  summary.c40 = c40_index(axes);
  return summary;
}

PopulationComparison compare_populations(const Population& a, const Population& b,
                                         const PopulationOptions& options) {
  check_has_blocks(a);
  check_has_blocks(b);
  const std::vector<Axes> axes_a = axes_for_ratios(a), axes_b = axes_for_ratios(b);
  PopulationComparison comparison{a.name, b.name, {}, {}};
  for (const ShapeMeasure& measure : shape_measures()) {
    comparison.measures.push_back(measure_difference(measure, a, axes_a, b, axes_b));
  }
  for (const std::string& scheme : options.selected_schemes()) {
    comparison.schemes.push_back(class_difference(scheme, a, axes_a, b, axes_b, options));
  }
  return comparison;
}

}  // namespace clast

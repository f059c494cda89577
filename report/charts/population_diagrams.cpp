#include "report/charts/population_diagrams.hpp"

#include <algorithm>
#include <cmath>

#include "report/charts/class_fraction_chart.hpp"
#include "report/charts/form_diagram.hpp"
#include "report/charts/palette.hpp"
#include "report/charts/rose_diagram.hpp"
#include "report/charts/svg_chart.hpp"
#include "report/html/html_page.hpp"
#include "report/tables/population_tables.hpp"

namespace clast::report_detail {
namespace {

constexpr std::size_t kMaxTitle = 44;  // characters of a name over a diagram
constexpr double kGarciaLimit = 0.3;   // s_c above which a block is elongated

std::string s_c_chart(const PopulationReport& report) {
  std::vector<ChartSeries> all;
  for (const ReportedPopulation& reported : report.populations) {
    ChartSeries series{reported.population.name, series_colour(all.size()), "", {}};
    const bool named = reported.population.blocks.size() <= kMaxNamedMarks;
    for (const MeasuredBlock& block : reported.population.blocks) {
      series.values.push_back(elongation_index(block.axes_in_table_unit));
      if (named) series.names.push_back(block.name);
    }
    all.push_back(std::move(series));
  }
  return draw_histogram({"Elongation s_c (Garcia et al. 2022)",
                         "s_c = L/I \xE2\x88\x92 1 (-)",
                         false,
                         {{kGarciaLimit, "elongated above 0.3"}}},
                        all);
}

FractionWithInterval share_bar(const ClassFraction& share, bool by_mass) {
  FractionWithInterval bar{by_mass ? share.mass_fraction : share.fraction,
                           by_mass ? share.mass_low : share.low,
                           by_mass ? share.mass_high : share.high,
                           {}};
  bar.note =
      (by_mass ? format_block_mass(share.mass) + " kg" : std::to_string(share.count) + " blocks") +
      ", " + format_percent(bar.value) + " (95 % interval " + format_percent(bar.low) + " to " +
      format_percent(bar.high) + ")";
  return bar;
}

/// Draws one population by number and by mass, or two populations by number.
std::string shares_chart(const PopulationReport& report, std::size_t scheme) {
  std::vector<ClassFractionSeries> all;
  std::vector<std::string> classes;
  const auto add = [&](const ReportedPopulation& reported, const std::string& name, bool by_mass) {
    ClassFractionSeries series{name, series_colour(all.size()), {}};
    classes.clear();
    for (const ClassFraction& share : reported.summary.schemes[scheme].fractions) {
      classes.push_back(share.name);
      series.shares.push_back(share_bar(share, by_mass));
    }
    all.push_back(std::move(series));
  };
  const bool two = report.populations.size() > 1;
  for (const ReportedPopulation& reported : report.populations) {
    add(reported, two ? reported.population.name : "by number", false);
    if (!two && reported.summary.blocks_with_mass > 0) add(reported, "by mass", true);
  }
  return draw_class_fractions(
      "Fractions of classes: " + report.populations[0].summary.schemes[scheme].scheme, classes,
      all);
}

ChartSeries size_series(const ReportedPopulation& reported, std::size_t number, bool by_mass) {
  ChartSeries series{
      by_mass ? "by mass" : "by number", series_colour(by_mass ? 1 : 0), by_mass ? "6 3" : "", {}};
  const bool named = reported.population.blocks.size() <= kMaxNamedMarks;
  for (std::size_t i = 0; i < reported.population.blocks.size(); ++i) {
    const MeasuredBlock& block = reported.population.blocks[i];
    if (block.unscaled || (by_mass && !block.mass)) continue;
    series.values.push_back(block_size(block.axes, reported.summary.size.measure));
    if (by_mass) series.weights.push_back(*block.mass);
    if (!named) continue;
    series.names.push_back(block.name + ", " + format_significant_digits(series.values.back(), 3) +
                           " m");
    series.blocks.push_back(block_highlight_attribute(number, i));
  }
  return series;
}

/// A fitted law from far below the smallest size to far above the largest.
ChartCurve law_curve(const FittedSizeLaw& law, double smallest, double largest) {
  constexpr int kSteps = 160;
  const bool normal = law.kind == SizeLawKind::kLogNormal;
  ChartCurve curve{name_of(law.kind) + " by number",
                   normal ? "#009E73" : "#6a6f76",
                   normal ? "2 2" : "8 3 2 3",
                   {}};
  for (int k = 0; k <= kSteps; ++k) {
    const double size =
        0.5 * smallest * std::pow(4.0 * largest / smallest, static_cast<double>(k) / kSteps);
    curve.points.emplace_back(size, law.fraction_below(size));
  }
  return curve;
}

/// The curves of all populations over each other, by number.
std::string sizes_chart(const PopulationReport& report) {
  std::vector<ChartSeries> all;
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    all.push_back(size_series(report.populations[i], i, false));
    all.back().name = report.populations[i].population.name;
    all.back().colour = series_colour(i);
  }
  const std::string measure = name_of(report.populations[0].summary.size.measure);
  return draw_cumulative_chart({"Sizes by number", "size " + measure + ", m", true}, all);
}

/// The curves of one, by number and by mass, and the laws fitted to the first.
std::string size_chart(const ReportedPopulation& reported, std::size_t number) {
  const SizeDistribution& size = reported.summary.size;
  std::vector<ChartSeries> series = {size_series(reported, number, false)};
  if (size.by_mass) series.push_back(size_series(reported, number, true));
  const auto [smallest, largest] =
      std::minmax_element(series[0].values.begin(), series[0].values.end());
  std::vector<ChartCurve> curves;
  for (const FittedSizeLaw& law : size.by_number.laws) {
    curves.push_back(law_curve(law, *smallest, *largest));
  }
  return draw_cumulative_chart({"Size: " + shorten_text(reported.population.name, kMaxTitle),
                                "size " + name_of(size.measure) + ", m", true},
                               series, curves);
}

/// Sizes of the blocks of a scanned deposit by number, by grid and corrected.
std::string found_sizes_chart(const ReportedPopulation& reported) {
  ChartSeries by_number{"blocks that show", series_colour(0), "", {}},
      by_grid{"by grid", series_colour(1), "6 3", {}},
      corrected{"corrected", series_colour(2), "2 2", {}};
  for (const MeasuredBlock& block : reported.population.blocks) {
    if (!block.deposit || block.unscaled) continue;
    for (ChartSeries* series : {&by_number, &by_grid, &corrected}) {
      series->values.push_back(block.axes.I);
    }
    const double confidence = block.deposit->confidence;
    by_number.weights.push_back(confidence);
    by_grid.weights.push_back(confidence * block.deposit->exposed_area);
    corrected.weights.push_back(confidence /
                                reported.deposit->correction.inclusion_probability(block.axes.I));
  }
  return draw_cumulative_chart({"Sizes that the surface shows, and all sizes", "size I, m", true},
                               {by_number, by_grid, corrected});
}

}  // namespace

std::string population_file_suffix(const PopulationReport& report, std::size_t number) {
  return report.populations.size() > 1 ? "_" + std::to_string(number + 1) : "";
}

bool has_scaled_blocks(const ReportedPopulation& reported) {
  return reported.summary.size.by_number.blocks > 0;
}

std::string format_block_mass(double mass) {
  return mass < 1e4 ? format_significant_digits(mass, 4) : format_fixed(mass, 0);
}

std::string class_fractions_diagram_name(const PopulationReport& report, std::size_t scheme) {
  return "shares_" + class_column_name(report.populations.front().summary.schemes[scheme].scheme);
}

PopulationDiagrams draw_population_diagrams(const PopulationReport& report) {
  PopulationDiagrams diagrams;
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    const ReportedPopulation& reported = report.populations[i];
    diagrams["sneed_folk" + population_file_suffix(report, i)] =
        draw_sneed_folk_diagram(reported.population, i, report.options);
    diagrams["zingg" + population_file_suffix(report, i)] =
        draw_zingg_diagram(reported.population, i, report.options);
    if (has_scaled_blocks(reported)) {
      diagrams["size" + population_file_suffix(report, i)] = size_chart(reported, i);
    }
    if (reported.deposit) {
      const LongAxisTrends& axes = reported.deposit->long_axes;
      diagrams["found_sizes" + population_file_suffix(report, i)] = found_sizes_chart(reported);
      diagrams["long_axes" + population_file_suffix(report, i)] =
          draw_rose_diagram(shorten_text(reported.population.name, kMaxTitle), series_colour(i),
                            axes.trends, axes.mean, {"north (+y)", "south"});
    }
  }
  const bool sized =
      std::any_of(report.populations.begin(), report.populations.end(), has_scaled_blocks);
  if (sized && report.populations.size() > 1) diagrams["sizes"] = sizes_chart(report);
  diagrams["s_c"] = s_c_chart(report);
  for (std::size_t i = 0; i < report.populations.front().summary.schemes.size(); ++i) {
    diagrams[class_fractions_diagram_name(report, i)] = shares_chart(report, i);
  }
  return diagrams;
}

}  // namespace clast::report_detail

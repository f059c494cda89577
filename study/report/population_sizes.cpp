#include "study/report/population_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "core/html_page.hpp"
#include "study/report/form_diagram.hpp"
#include "study/report/palette.hpp"
#include "study/report/report_page.hpp"
#include "study/report/svg_chart.hpp"

namespace clast {
namespace {

constexpr std::size_t kMostTitle = 44;  // characters of a name over a diagram

Series size_series(const ReportedPopulation& reported, std::size_t number, bool by_mass) {
  Series series{
      by_mass ? "by mass" : "by number", data_colour(by_mass ? 1 : 0), by_mass ? "6 3" : "", {}};
  const bool named = reported.population.blocks.size() <= kMostNamedMarks;
  for (std::size_t i = 0; i < reported.population.blocks.size(); ++i) {
    const MeasuredBlock& block = reported.population.blocks[i];
    if (block.unscaled || (by_mass && !block.mass)) continue;
    series.values.push_back(block_size(block.axes, reported.summary.size.measure));
    if (by_mass) series.weights.push_back(*block.mass);
    if (!named) continue;
    series.names.push_back(block.name + ", " + significant(series.values.back(), 3) + " m");
    series.blocks.push_back(block_key(number, i));
  }
  return series;
}

/// A fitted law from far below the smallest size to far above the largest.
Curve law_curve(const SizeLaw& law, double smallest, double largest) {
  constexpr int kSteps = 160;
  const bool normal = law.kind == SizeLawKind::kLogNormal;
  Curve curve{name_of(law.kind) + " by number",
              normal ? "#009E73" : "#6a6f76",
              normal ? "2 2" : "8 3 2 3",
              {}};
  for (int k = 0; k <= kSteps; ++k) {
    const double size =
        0.5 * smallest * std::pow(4.0 * largest / smallest, static_cast<double>(k) / kSteps);
    curve.points.emplace_back(size, law.below(size));
  }
  return curve;
}

std::string with_error(double value, double error) {
  return significant(value, 3) + " \xC2\xB1 " + significant(error, 2);
}

void law_rows(HtmlTable& table, const std::string& weighting, const SizeCurve& curve) {
  for (const SizeLaw& law : curve.laws) {
    const bool normal = law.kind == SizeLawKind::kLogNormal;
    table.row(
        {name_of(law.kind) + " " + weighting,
         (normal ? "median " : "d63 ") + with_error(law.location, law.location_error),
         (normal ? "\xCF\x83 of ln " : "exponent ") + with_error(law.spread, law.spread_error),
         fixed(law.distance, 3), law.p_value ? p_words(*law.p_value) : "-"});
  }
}

}  // namespace

std::string population_suffix(const PopulationReport& report, std::size_t number) {
  return report.populations.size() > 1 ? "_" + std::to_string(number + 1) : "";
}

bool has_sizes(const ReportedPopulation& reported) {
  return reported.summary.size.by_number.blocks > 0;
}

std::string sizes_chart(const PopulationReport& report) {
  std::vector<Series> all;
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    all.push_back(size_series(report.populations[i], i, false));
    all.back().name = report.populations[i].population.name;
    all.back().colour = data_colour(i);
  }
  const std::string measure = name_of(report.populations[0].summary.size.measure);
  return cumulative_chart({"Sizes by number", "size " + measure + ", m", true}, all);
}

std::string size_chart(const ReportedPopulation& reported, std::size_t number) {
  const SizeDistribution& size = reported.summary.size;
  std::vector<Series> series = {size_series(reported, number, false)};
  if (size.by_mass) series.push_back(size_series(reported, number, true));
  const auto [smallest, largest] =
      std::minmax_element(series[0].values.begin(), series[0].values.end());
  std::vector<Curve> curves;
  for (const SizeLaw& law : size.by_number.laws) {
    curves.push_back(law_curve(law, *smallest, *largest));
  }
  return cumulative_chart({"Size: " + shortened(reported.population.name, kMostTitle),
                           "size " + name_of(size.measure) + ", m", true},
                          series, false, curves);
}

std::string size_section(const PopulationReport& report, const Diagrams& diagrams) {
  std::string html;
  if (diagrams.contains("sizes")) {
    std::string medians;
    for (const ReportedPopulation& reported : report.populations) {
      if (!has_sizes(reported)) continue;
      medians += paragraph("Half of the blocks of " + reported.population.name + " are below " +
                           significant(reported.summary.size.by_number.d50, 3) + " m.");
    }
    html += "<div class=\"charts\">" + figure(diagrams.at("sizes")) + "<div>" + medians +
            "</div></div>\n";
  }
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    const ReportedPopulation& reported = report.populations[i];
    const SizeDistribution& size = reported.summary.size;
    if (!has_sizes(reported)) {
      html +=
          paragraph(reported.population.name + ": every block is unscaled; there are no sizes.");
      continue;
    }
    HtmlTable percentiles(
        {shortened(reported.population.name, kMostHead), "blocks", "d10, m", "d50, m", "d90, m"},
        1);
    const auto add = [&](const std::string& name, const SizeCurve& curve) {
      percentiles.row({name, std::to_string(curve.blocks), significant(curve.d10, 3),
                       significant(curve.d50, 3), significant(curve.d90, 3)});
    };
    add("by number", size.by_number);
    if (size.by_mass) add("by mass", *size.by_mass);
    HtmlTable laws({"law", "size, m", "spread", "KS distance", "p"}, 3);
    law_rows(laws, "by number", size.by_number);
    if (size.by_mass) law_rows(laws, "by mass", *size.by_mass);
    html += "<div class=\"charts\">" + figure(diagrams.at("size" + population_suffix(report, i))) +
            "<div>" + percentiles.html() + "</div></div>\n";
    html += size.by_number.laws.empty() ? paragraph("All blocks are of one size: no law is fitted.")
                                        : laws.html();
    if (size.step > 0.0) {
      html += paragraph("Sizes were read in steps of " + significant(size.step, 2) +
                        " m; fits are judged with samples read in the same steps.");
    }
    html += "<ul>\n";
    for (const SizeShape& one : reported.summary.size_and_shape) {
      html += "<li>" + escaped(size_shape_words(one, size.measure)) + "</li>\n";
    }
    html +=
        "<li>" +
        escaped("C40, the share of blocks with S/L at most 0.4: " + percent(reported.summary.c40) +
                ".") +
        "</li>\n</ul>\n";
  }
  return section(
      "Sizes",
      paragraph(
          "Laws are fitted by maximum likelihood, with standard errors. p is the chance that a "
          "sample of the law lies as far from its own fit: a small p speaks against the law, "
          "a large one does not prove it. By mass there is no p, since the kilograms of one "
          "block are not independent of each other.") +
          html);
}

}  // namespace clast

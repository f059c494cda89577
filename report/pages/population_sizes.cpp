#include "report/pages/population_sizes.hpp"

#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

std::string with_error(double value, double error) {
  return format_significant_digits(value, 3) + " \xC2\xB1 " + format_significant_digits(error, 2);
}

void law_rows(HtmlTable& table, const std::string& weighting, const SizeCurve& curve) {
  for (const FittedSizeLaw& law : curve.laws) {
    const bool normal = law.kind == SizeLawKind::kLogNormal;
    table.row(
        {name_of(law.kind) + " " + weighting,
         (normal ? "median " : "d63 ") + with_error(law.location, law.location_error),
         (normal ? "\xCF\x83 of ln " : "exponent ") + with_error(law.spread, law.spread_error),
         format_fixed(law.distance, 3), law.p_value ? format_p_value(*law.p_value) : "-"});
  }
}

}  // namespace

std::string format_size_section(const PopulationReport& report,
                                const PopulationDiagrams& diagrams) {
  std::string html;
  if (diagrams.contains("sizes")) {
    std::string medians;
    for (const ReportedPopulation& reported : report.populations) {
      if (!has_scaled_blocks(reported)) continue;
      medians += format_paragraph(
          "Half of the blocks of " + reported.population.name + " are smaller than " +
          format_significant_digits(reported.summary.size.by_number.d50, 3) + " m.");
    }
    html += "<div class=\"charts\">" + format_figure(diagrams.at("sizes")) + "<div>" + medians +
            "</div></div>\n";
  }
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    const ReportedPopulation& reported = report.populations[i];
    const SizeDistribution& size = reported.summary.size;
    if (!has_scaled_blocks(reported)) {
      html += format_paragraph(reported.population.name +
                               ": all blocks are unscaled, so there are no sizes.");
      continue;
    }
    HtmlTable percentiles({shorten_text(reported.population.name, kMaxHeadLength), "blocks",
                           "d10, m", "d50, m", "d90, m"},
                          1);
    const auto add = [&](const std::string& name, const SizeCurve& curve) {
      percentiles.row({name, std::to_string(curve.blocks), format_significant_digits(curve.d10, 3),
                       format_significant_digits(curve.d50, 3),
                       format_significant_digits(curve.d90, 3)});
    };
    add("by number", size.by_number);
    if (size.by_mass) add("by mass", *size.by_mass);
    HtmlTable laws({"law", "size, m", "spread", "KS distance", "p"}, 3);
    law_rows(laws, "by number", size.by_number);
    if (size.by_mass) law_rows(laws, "by mass", *size.by_mass);
    html += "<div class=\"charts\">" +
            format_figure(diagrams.at("size" + population_file_suffix(report, i))) + "<div>" +
            percentiles.html() + "</div></div>\n";
    html += size.by_number.laws.empty()
                ? format_paragraph("All blocks have the same size, so no law is fitted.")
                : laws.html();
    if (size.step > 0.0) {
      html += format_paragraph("Sizes were read in steps of " +
                               format_significant_digits(size.step, 2) +
                               " m; the p-values use samples rounded to the same steps.");
    }
    html += "<ul>\n";
    for (const SizeShapeCorrelation& one : reported.summary.size_shape_correlations) {
      html += "<li>" + escape_html(describe_size_shape(one, size.measure)) + "</li>\n";
    }
    html += "<li>" +
            escape_html("C40, the fraction of blocks with S/L at most 0.4: " +
                        format_percent(reported.summary.c40) + ".") +
            "</li>\n</ul>\n";
  }
  return format_section(
      "Sizes",
      format_paragraph("The laws are fitted by maximum likelihood, with standard errors. p is the "
                       "probability that a sample drawn from the law has an equal or larger KS "
                       "distance to its own fit: a small p is evidence against the law, but a "
                       "large p does not prove it. There is no p for the distribution by mass, "
                       "because the kilograms of one block are not independent of each other.") +
          html);
}

}  // namespace clast::report_detail

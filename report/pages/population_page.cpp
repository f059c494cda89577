#include "report/pages/population_page.hpp"

#include <algorithm>

#include "classify/box_effect.hpp"
#include "classify/certainty.hpp"
#include "core/number_text.hpp"
#include "core/version.hpp"
#include "report/charts/form_diagram.hpp"
#include "report/html/html_page.hpp"
#include "report/html/report_page.hpp"
#include "report/pages/population_sizes.hpp"
#include "report/pages/scanned_deposit_section.hpp"

namespace clast::report_detail {
namespace {

constexpr std::size_t kMaxRows = 500;  // of the table of blocks
constexpr std::size_t kMaxNotes = 20;

/// "22.8-41.7 %", with a dash that is no minus
std::string range_text(double low, double high) {
  return format_fixed(100.0 * low, 1) + "\xE2\x80\x93" + format_percent(high);
}

std::string population_head(const PopulationReport& report) {
  std::string title, facts;
  std::vector<std::string> notes;
  for (const ReportedPopulation& reported : report.populations) {
    title += (title.empty() ? "" : " and ") + reported.population.name;
    std::string text = format_count(reported.summary.blocks, "block");
    if (reported.summary.blocks_with_mass > 0) {
      text += ", " + std::to_string(reported.summary.blocks_with_mass) + " with a mass, " +
              format_block_mass(reported.summary.size.total_mass) + " kg";
    }
    facts += format_fact(reported.population.name, text);
    facts += format_fact("L, I, S of " + reported.population.name, reported.measured);
    for (std::size_t i = 0; i < std::min(kMaxNotes, reported.notes.size()); ++i) {
      notes.push_back(reported.population.name + ": " + reported.notes[i]);
    }
    if (reported.notes.size() > kMaxNotes) {
      notes.push_back(reported.population.name + ": there are " +
                      std::to_string(reported.notes.size() - kMaxNotes) +
                      " more notes; all are in provenance.json");
    }
    if (reported.population.blocks.size() > kMaxSingleBlocks) {
      notes.push_back(
          reported.population.name + ": with " + format_count(reported.summary.blocks, "block") +
          ", the diagrams show densities instead of single blocks; every block is in classes.csv");
    }
  }
  facts +=
      format_fact("Size", name_of(report.options.size) +
                              (report.options.size == SizeMeasure::kIntermediate
                                   ? ", the axis that determines whether a block passes a sieve"
                                   : ", the side of a cube with the volume of the block's box"));
  facts += format_fact("Report by", std::string("clast ") + version());
  return "<h1>Shapes and sizes of blocks</h1>\n<p class=\"lead\">" + escape_html(title) + "</p>\n" +
         (notes.empty() ? std::string() : format_note_box("Read this first", notes)) +
         "<dl class=\"facts\">\n" + facts + "</dl>\n";
}

std::string comparison_section(const PopulationReport& report) {
  if (!report.comparison) return {};
  const PopulationComparison& comparison = *report.comparison;
  std::string html = "<ul>\n";
  for (const ClassFractionDifference& one : comparison.schemes)
    html += "<li>" + escape_html(one.description) + "</li>\n";
  for (const ShapeMeasureDifference& one : comparison.measures) {
    html += "<li>" + escape_html(one.description) + "</li>\n";
  }
  const std::size_t tests = comparison.schemes.size() + comparison.measures.size();
  html +=
      "</ul>\n" +
      format_paragraph(
          "These are " + std::to_string(tests) +
          " tests of the same blocks: among twenty tests of equal deposits, one gives p < 0.05 on "
          "average. If no difference is significant, the samples may be too small to detect it.");
  return format_section(comparison.name_a + " against " + comparison.name_b, html);
}

std::string classes_section(const PopulationReport& report, const PopulationDiagrams& diagrams) {
  std::string html;
  const std::size_t schemes = report.populations.front().summary.schemes.size();
  for (std::size_t scheme = 0; scheme < schemes; ++scheme) {
    html += "<h3>" + escape_html(report.populations[0].summary.schemes[scheme].scheme) + "</h3>\n";
    html += "<div class=\"beside\">" +
            format_figure(diagrams.at(class_fractions_diagram_name(report, scheme))) + "<div>";
    for (const ReportedPopulation& reported : report.populations) {
      const bool weighed = reported.summary.blocks_with_mass > 0;
      std::vector<std::string> heads = {"class", "blocks", "fraction", "95 % interval"};
      if (weighed) {
        for (const char* name : {"mass, kg", "by mass", "95 % interval"}) heads.push_back(name);
      }
      if (report.populations.size() > 1) html += format_paragraph(reported.population.name);
      HtmlTable table(heads, 1);
      for (const ClassFraction& share : reported.summary.schemes[scheme].fractions) {
        std::vector<std::string> cells = {share.name, std::to_string(share.count),
                                          format_percent(share.fraction),
                                          range_text(share.low, share.high)};
        if (weighed) {
          cells.push_back(format_block_mass(share.mass));
          cells.push_back(format_percent(share.mass_fraction));
          cells.push_back(range_text(share.mass_low, share.mass_high));
        }
        table.row(std::move(cells));
      }
      html += table.html();
    }
    html += "</div></div>\n";
  }
  return format_section(
      "Classes",
      format_paragraph(
          "The intervals are Wilson's 95 % intervals of the fraction in the whole deposit. "
          "Fractions by mass depend on a few heavy blocks, so their intervals are wider.") +
          html);
}

std::string diagrams_section(const PopulationReport& report, const PopulationDiagrams& diagrams) {
  std::string html = "<div class=\"charts\">\n";
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    html += format_figure(diagrams.at("sneed_folk" + population_file_suffix(report, i)));
    html += format_figure(diagrams.at("zingg" + population_file_suffix(report, i)));
  }
  html += format_figure(diagrams.at("s_c"));
  return format_section(
      "Forms", format_paragraph("Point at a mark to see the name of its block and highlight it in "
                                "all diagrams. Darker fields contain more blocks.") +
                   html + "</div>\n");
}

/// Describes the effect of the choice of box; empty for taped axes.
std::string boxes_section(const PopulationReport& report) {
  std::string html;
  for (const ReportedPopulation& reported : report.populations) {
    const std::vector<MeasuredBlock>& blocks = reported.population.blocks;
    std::string words;
    for (const BoxConventionEffect& effect : compare_box_conventions(
             blocks, report.options.selected_schemes(), report.options.limits)) {
      words += "<li>" + escape_html(describe_box_convention_effect(effect)) + "</li>\n";
    }
    if (words.empty()) continue;
    if (report.populations.size() > 1) html += format_paragraph(reported.population.name);
    html += "<ul>\n" + words + "</ul>\n";
    if (blocks.size() > kMaxRows) continue;
    std::vector<std::string> heads = {shorten_text(reported.population.name, kMaxHeadLength)};
    for (const BoxConvention box : kBoxConventions) heads.push_back("s_c, " + name_of(box));
    for (const BoxConvention box : kBoxConventions) heads.push_back("S/L, " + name_of(box));
    HtmlTable table(heads, 1);
    for (const MeasuredBlock& block : blocks) {
      if (block.axes_by_box.empty()) continue;
      std::vector<std::string> cells = {block.name};
      for (const Axes& axes : block.axes_by_box)
        cells.push_back(format_fixed(elongation_index(axes), 3));
      for (const Axes& axes : block.axes_by_box) cells.push_back(format_fixed(axes.S / axes.L, 3));
      table.row(std::move(cells));
    }
    html += table.html();
  }
  if (html.empty()) return {};
  return format_section(
      "Boxes", format_paragraph("L, I and S are the sides of a box, and the convention for the box "
                                "can change the class of blocks near a class limit. Compare only "
                                "blocks that were measured with the same convention.") +
                   html);
}

std::string blocks_section(const PopulationReport& report) {
  std::string html;
  for (const ReportedPopulation& reported : report.populations) {
    const std::vector<MeasuredBlock>& blocks = reported.population.blocks;
    if (blocks.size() > kMaxRows) {
      html +=
          format_paragraph(reported.population.name + ": " + format_count(blocks.size(), "block") +
                           "; all of them are in classes.csv.");
      continue;
    }
    std::vector<std::string> heads = {shorten_text(reported.population.name, kMaxHeadLength)};
    for (const SchemeFractions& scheme : reported.summary.schemes) heads.push_back(scheme.scheme);
    const std::string& first = reported.summary.schemes.front().scheme;
    heads.push_back("certainty (" + first + ")");
    const std::size_t text = heads.size();
    for (const char* name : {"L, m", "I, m", "S, m", "mass, kg", "s_c", "S/L"})
      heads.push_back(name);
    HtmlTable table(heads, text);
    for (const MeasuredBlock& block : blocks) {
      std::vector<std::string> cells = {block.name};
      for (const SchemeFractions& scheme : reported.summary.schemes) {
        cells.push_back(
            shape_class(scheme.scheme, block.axes_in_table_unit, report.options.limits));
      }
      const ClassCertainty certainty =
          assess_class_certainty(first, block.axes, block.axis_error, report.options.limits);
      cells.push_back(certainty.near_limit ? describe_certainty(certainty)
                                           : "far from class limits");
      for (const double axis : {block.axes.L, block.axes.I, block.axes.S}) {
        cells.push_back(format_significant_digits(axis, 3) + (block.unscaled ? " u" : ""));
      }
      cells.push_back(block.mass ? format_significant_digits(*block.mass, 4) : "-");
      cells.push_back(format_fixed(elongation_index(block.axes_in_table_unit), 2));
      cells.push_back(format_fixed(block.axes_in_table_unit.S / block.axes_in_table_unit.L, 2));
      table.row(std::move(cells));
    }
    html += table.html();
  }
  return format_section("Blocks", html);
}

std::string sources_section(const PopulationReport& report) {
  std::string html = "<ul class=\"note\">\n";
  for (const ReportedPopulation& reported : report.populations) {
    for (const InputFile& input : reported.inputs) {
      html += "<li><code>" + escape_html(input.file + " " + input.sha256) + "</code></li>\n";
    }
  }
  return format_section("Inputs", html + "</ul>\n") + "<footer>Made by clast " +
         escape_html(version()) + ", random samples from seed " +
         std::to_string(report.options.seed) +
         ". All numbers of this page are in classes.csv, shares.csv, sizes.csv and tests.csv in "
         "the same folder; every diagram is there as an .svg file.</footer>\n";
}

}  // namespace

std::string make_population_page(const PopulationReport& report,
                                 const PopulationDiagrams& diagrams) {
  std::string title = "Blocks";
  for (const ReportedPopulation& reported : report.populations) {
    title += (&reported == &report.populations.front() ? ": " : ", ") + reported.population.name;
  }
  return make_report_page(
      title, population_head(report) + comparison_section(report) +
                 classes_section(report, diagrams) + diagrams_section(report, diagrams) +
                 format_size_section(report, diagrams) +
                 format_scanned_deposit_section(report, diagrams) + blocks_section(report) +
                 boxes_section(report) + sources_section(report));
}

}  // namespace clast::report_detail

#include "report/pages/report_sections.hpp"

#include <cctype>

#include "report/html/html_page.hpp"
#include "report/text/key_figures.hpp"
#include "report/text/key_results_text.hpp"

namespace clast::report_detail {
namespace {

/// Cautions shown at once; of more, the others are folded.
constexpr std::size_t kMaxCautions = 3;

/// Escaped, with numbers and units that stay on one line.
std::string unbroken(const std::string& text) {
  std::string html = escape_html(text);
  for (const std::string unit : {"%", "m", "kJ", "J", "kg"}) {
    for (std::size_t at = 0; (at = html.find(" " + unit, at)) != html.npos; ++at) {
      const std::size_t end = at + 1 + unit.size();
      const bool number = at > 0 && std::isdigit(static_cast<unsigned char>(html[at - 1]));
      const bool whole = end == html.size() || !std::isalnum(static_cast<unsigned char>(html[end]));
      if (number && whole) html.replace(at, 1, "&nbsp;");
    }
  }
  return html;
}

std::string figures_of(const Comparison& comparison, const KeyResults& answer) {
  std::string html = "<dl class=\"figures\">\n";
  for (const KeyFigure& figure : select_key_figures(comparison, answer)) {
    html += "<div><dd class=\"value\">" + unbroken(figure.value) + "</dd><dt>" +
            unbroken(figure.label) + "</dt>" +
            (figure.range.empty() ? "" : "<dd>(" + escape_html(figure.range) + ")</dd>") +
            (figure.more.empty() ? "" : "<dd>" + unbroken(figure.more) + "</dd>") + "</div>\n";
  }
  return html + "</dl>\n";
}

/// A line that unfolds to the warnings in full.
std::string caution_line(const ComparisonWarning& caution) {
  std::string texts;
  for (const std::string& text : caution.texts) texts += format_paragraph(text);
  return format_folded_section(caution.brief, texts);
}

std::string cautions_of(const Comparison& comparison) {
  const std::vector<ComparisonWarning>& cautions = comparison.cautions;
  if (cautions.empty()) return "";
  std::string html = "<div class=\"warnings\" role=\"note\">\n", more;
  for (std::size_t i = 0; i < cautions.size(); ++i) {
    (i < kMaxCautions ? html : more) += caution_line(cautions[i]);
  }
  if (!more.empty()) {
    html +=
        format_folded_section(format_count(cautions.size() - kMaxCautions, "more caution"), more);
  }
  return html + "</div>\n";
}

}  // namespace

std::string format_head_section(const Comparison& comparison, const KeyResults& answer) {
  std::string html = "<header id=\"answer\">\n<h1>Rockfall runs compared by shape</h1>\n";
  html += "<p class=\"lead\">" + escape_html(describe_runs(comparison)) + "</p>\n";
  for (const std::string& sentence : describe_key_results(comparison, answer)) {
    html += "<p class=\"answer\">" + unbroken(sentence) + "</p>\n";
  }
  html += figures_of(comparison, answer);
  html +=
      "<p class=\"note\">" +
      escape_html(describe_intervals(answer) + " " + describe_validity_limits(comparison, answer)) +
      "</p>\n";
  return html + cautions_of(comparison) + "</header>\n";
}

}  // namespace clast::report_detail

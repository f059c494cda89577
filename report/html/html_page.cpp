#include "report/html/html_page.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "report/html/assets.hpp"

namespace clast::report_detail {
namespace {

/// Escaped text with what stands between backticks, the field of an option, as code.
std::string with_code(std::string_view text) {
  std::string html = escape_html(text);
  std::size_t begin = html.find('`');
  for (std::size_t end; begin != html.npos; begin = html.find('`', begin)) {
    end = html.find('`', begin + 1);
    if (end == html.npos) break;
    html.replace(end, 1, "</code>").replace(begin, 1, "<code>");
  }
  return html;
}

/// "Along the slope" to "along-the-slope".
std::string anchor(std::string_view title) {
  std::string id;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte)) {
      id += static_cast<char>(std::tolower(byte));
    } else if (!id.empty() && id.back() != '-') {
      id += '-';
    }
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id;
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default: {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 || c == '\n' || c == '\t') result += c;
      }
    }
  }
  return result;
}

std::string shorten_text(std::string_view text, std::size_t maximum) {
  std::size_t characters = 0, end = 0;  // up to and with the last character that has room
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) == 0x80) continue;
    if (++characters == maximum) end = i;
    if (characters > maximum) return std::string(text.substr(0, end)) + "\xE2\x80\xA6";
  }
  return std::string(text);
}

std::string format_link_target(std::string_view path) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string link;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '/' || c == '.' || c == '_' || c == '-';
    if (plain) {
      link += c;
    } else {
      link += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return link;
}

std::string format_fixed(double value, int decimals) {
  return std::isfinite(value) ? format_decimals(value, decimals) : "-";
}

std::string format_significant_digits(double value, int digits) {
  return std::isfinite(value) ? format_rounded(value, digits) : "-";
}

HtmlTable::HtmlTable(std::vector<std::string> heads, std::size_t text_columns)
    : heads_(std::move(heads)), text_columns_(text_columns) {}

HtmlTable& HtmlTable::row(std::vector<std::string> cells) {
  constexpr std::size_t kLongText = 24;  // broken anywhere from here on, if there is no room
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    add_cell(i, cells[i].size() > kLongText, escape_html(cells[i]));
  }
  rows_ += "</tr>\n";
  return *this;
}

HtmlTable& HtmlTable::add_html_row(const std::vector<std::string>& cells) {
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) add_cell(i, false, cells[i]);
  rows_ += "</tr>\n";
  return *this;
}

HtmlTable& HtmlTable::show_as_cards() {
  cards_ = true;
  return *this;
}

void HtmlTable::add_cell(std::size_t column, bool long_text, const std::string& html) {
  const bool text = column < text_columns_;
  rows_ += "<td";
  if (text) rows_ += long_text ? " class=\"t wrap\"" : " class=\"t\"";
  if (cards_) rows_ += " data-head=\"" + escape_html(heads_[column]) + "\"";
  rows_ += ">" + html + "</td>";
}

std::string HtmlTable::html() const {
  constexpr std::size_t kWide = 10;  // columns from which a table is set closer
  std::string html = "<div class=\"scroll\"><table";
  if (cards_) {
    html += " class=\"cards\"";
  } else if (heads_.size() >= kWide) {
    html += " class=\"wide\"";
  }
  html += "><thead><tr>";
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    html += i < text_columns_ ? "<th class=\"t\">" : "<th>";
    html += escape_html(heads_[i]) + "</th>";
  }
  return html + "</tr></thead>\n<tbody>\n" + rows_ + "</tbody></table></div>\n";
}

std::string format_svg_line(double x1, double y1, double x2, double y2, std::string_view style) {
  return "<line x1=\"" + format_fixed(x1, 1) + "\" y1=\"" + format_fixed(y1, 1) + "\" x2=\"" +
         format_fixed(x2, 1) + "\" y2=\"" + format_fixed(y2, 1) + "\" " + std::string(style) + "/>";
}

std::string svg_text(double x, double y, std::string_view text, std::string_view style) {
  return "<text x=\"" + format_fixed(x, 1) + "\" y=\"" + format_fixed(y, 1) + "\" " +
         std::string(style) + ">" + escape_html(text) + "</text>";
}

std::string open_svg(double width, double height, std::string_view label) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + format_fixed(width, 0) + " " +
         format_fixed(height, 0) + "\" role=\"img\" aria-label=\"" + escape_html(label) + "\">";
}

std::string make_svg_file(const std::string& svg) {
  const std::string_view box = "viewBox=\"0 0 ";
  const std::size_t at = svg.find(box) + box.size();
  const std::string size = svg.substr(at, svg.find('"', at) - at);  // "width height"
  const std::string width = size.substr(0, size.find(' '));
  const std::string height = size.substr(size.find(' ') + 1);
  const std::size_t end = svg.find('>') + 1;
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg width=\"" + width + "\" height=\"" +
         height + "\" font-family=\"Helvetica, Arial, sans-serif\"" + svg.substr(4, end - 4) +
         "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"#fff\"/>" +
         svg.substr(end);
}

std::string fill_template(std::string_view skeleton,
                          const std::map<std::string, std::string>& values) {
  std::string filled;
  for (std::size_t at = 0;;) {
    const std::size_t open = skeleton.find("{{", at);
    filled += skeleton.substr(at, open - at);
    if (open == std::string_view::npos) return filled;
    const std::size_t close = skeleton.find("}}", open);
    filled += values.at(std::string(skeleton.substr(open + 2, close - open - 2)));
    at = close + 2;
  }
}

std::string format_section(std::string_view title, std::string_view body) {
  return "<section id=\"" + anchor(title) + "\">\n<h2>" + escape_html(title) + "</h2>\n" +
         std::string(body) + "</section>\n";
}

std::string format_folded_section(std::string_view line, std::string_view body,
                                  PrintedState on_paper) {
  const std::string classes = on_paper == PrintedState::kOpen ? "fold paper" : "fold";
  return "<details class=\"" + classes + "\"><summary>" + escape_html(line) + "</summary>\n" +
         std::string(body) + "</details>\n";
}

std::string format_paragraph(std::string_view text) { return "<p>" + with_code(text) + "</p>\n"; }

std::string format_figure(std::string_view svg, std::string_view caption) {
  std::string html = "<figure>" + std::string(svg);
  if (!caption.empty()) html += "<figcaption>" + escape_html(caption) + "</figcaption>";
  return html + "</figure>\n";
}

std::string format_fact(std::string_view name, std::string_view value) {
  return "<div><dt>" + escape_html(name) + "</dt><dd>" + escape_html(value) + "</dd></div>\n";
}

std::string format_note_box(std::string_view title, const std::vector<std::string>& notes) {
  std::string html =
      "<div class=\"warnings\" role=\"note\"><h2>" + escape_html(title) + "</h2><ul>\n";
  for (const std::string& note : notes) html += "<li>" + with_code(note) + "</li>\n";
  return html + "</ul></div>\n";
}

std::string format_page(std::string_view title, std::string_view body, const PageExtras& extras) {
  return fill_template(assets::page_html,
                       {{"title", escape_html(title)},
                        {"style", std::string(assets::page_css) + std::string(extras.style)},
                        {"body", std::string(body)},
                        {"script", std::string(assets::page_js) + std::string(extras.script)}});
}

}  // namespace clast::report_detail

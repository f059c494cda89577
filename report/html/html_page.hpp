#pragma once
/// Elements of HTML pages: escaped text, numbers, tables, SVG elements, page frame.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/number_text.hpp"

namespace clast::report_detail {

/// Escapes a text for HTML elements and quoted attributes, and removes control characters.
std::string escape_html(std::string_view text);

/// Shortens a UTF-8 text to at most `maximum` characters. A shortened text ends with ….
std::string shorten_text(std::string_view text, std::size_t maximum);

/// Formats a relative path as link target, with special characters as %XX.
std::string format_link_target(std::string_view path);

/// Formats a number with fixed decimals; "-" if it is not finite.
std::string format_fixed(double value, int decimals);
/// Formats a number with significant digits. Only very large or small numbers have an exponent.
std::string format_significant_digits(double value, int digits = 3);

/// Sortable HTML table. All columns except the first `text_columns` are numeric.
class HtmlTable {
 public:
  HtmlTable(std::vector<std::string> heads, std::size_t text_columns);

  HtmlTable& row(std::vector<std::string> cells);  ///< adds a row of plain texts, which are escaped
  HtmlTable& add_html_row(const std::vector<std::string>& cells);  ///< adds a row of HTML cells
  /// Makes narrow pages show rows as cards with the column heads. Must be called before the first
  /// row.
  HtmlTable& show_as_cards();
  std::string html() const;

 private:
  void add_cell(std::size_t column, bool long_text, const std::string& html);

  std::vector<std::string> heads_;
  std::size_t text_columns_;
  bool cards_ = false;
  std::string rows_;
};

/// Formats an SVG line element. Coordinates are in px; `style` has further attributes.
std::string format_svg_line(double x1, double y1, double x2, double y2, std::string_view style);
std::string svg_text(double x, double y, std::string_view text, std::string_view style = {});
/// Formats the opening tag of an SVG image that scales with the page.
std::string open_svg(double width, double height, std::string_view label);

/// Makes a standalone SVG file from an SVG image of a page.
std::string make_svg_file(const std::string& svg);

/// Replaces each {{name}} in an HTML template by its value (HTML).
std::string fill_template(std::string_view skeleton,
                          const std::map<std::string, std::string>& values);

/// Formats a section of a page with its heading. Its id is the title in lower case, with dashes for
/// spaces.
std::string format_section(std::string_view title, std::string_view body);
/// State of a collapsible section on a printed page.
enum class PrintedState { kLeftOut, kOpen };
/// Formats a collapsible section: a line of plain text, and an HTML body shown after a click.
std::string format_folded_section(std::string_view line, std::string_view body,
                                  PrintedState on_paper = PrintedState::kLeftOut);
/// Formats a paragraph of plain text. Text in backticks is formatted as code.
std::string format_paragraph(std::string_view text);
std::string format_figure(std::string_view svg, std::string_view caption = {});
/// Formats one entry of a list of names and values (<dl>).
std::string format_fact(std::string_view name, std::string_view value);
/// Formats a highlighted box with a list of warnings.
std::string format_note_box(std::string_view title, const std::vector<std::string>& notes);

/// Additional style and script of a page.
struct PageExtras {
  std::string_view style = {};   ///< CSS
  std::string_view script = {};  ///< JavaScript, executed at the end of the page
};

/// Formats a complete page with its style and with the script that sorts tables.
std::string format_page(std::string_view title, std::string_view body,
                        const PageExtras& extras = {});

}  // namespace clast::report_detail

#pragma once
/// The parts a page is written with: escaped text, numbers, tables, SVG elements, the page frame.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/number_text.hpp"

namespace clast::report_detail {

/// Text for element content and quoted attributes: & < > " ' escaped, control characters dropped.
std::string escape_html(std::string_view text);

/// UTF-8 text of so many characters at most, the last a … where some were cut off: for names in
/// pictures, which don't grow with them.
std::string shorten_middle(std::string_view text, std::size_t most);

/// A path below the page's folder as the href of a link: all but plain letters, digits, and /._-
/// as %XX.
std::string format_link_target(std::string_view path);

/// A number with so many decimals; "-" when it is not finite.
std::string fixed(double value, int decimals);
/// A number with so many significant digits, with an exponent only when very large or small.
std::string significant(double value, int digits = 3);

/// A table; all but the first `text_columns` columns are numbers. Rows are sorted by a click on a
/// column's head.
class HtmlTable {
 public:
  HtmlTable(std::vector<std::string> heads, std::size_t text_columns);

  HtmlTable& row(std::vector<std::string> cells);              ///< plain text, escaped here
  HtmlTable& html_row(const std::vector<std::string>& cells);  ///< HTML, as it is
  /// Cells carry the heads of their columns, with which scans.css makes a card of each row on
  /// narrow pages. Before the first row.
  HtmlTable& as_cards();
  std::string html() const;

 private:
  void add_cell(std::size_t column, bool long_text, const std::string& html);

  std::vector<std::string> heads_;
  std::size_t text_columns_;
  bool cards_ = false;
  std::string rows_;
};

/// "<line .../>" and "<text ...>": coordinates in px, `style` as further attributes.
std::string format_svg_line(double x1, double y1, double x2, double y2, std::string_view style);
std::string svg_text(double x, double y, std::string_view text, std::string_view style = {});
/// Opening "<svg ...>" that scales with the page.
std::string open_svg(double width, double height, std::string_view label);

/// A picture of a page as a file of its own: white below it, a font named, its size in px.
std::string make_svg_file(const std::string& svg);

/// An HTML asset with every {{name}} in it replaced by its value, which is HTML.
std::string fill(std::string_view skeleton, const std::map<std::string, std::string>& values);

/// "<section id=title><h2>title</h2>body</section>", with the id in small letters and dashes.
std::string section(std::string_view title, std::string_view body);
/// What a page does with a fold when it is printed.
enum class PrintedState { kLeftOut, kOpen };
/// What is seen once its one line is clicked: plain text, and HTML below it.
std::string folded(std::string_view line, std::string_view body,
                   PrintedState on_paper = PrintedState::kLeftOut);
/// Plain text, escaped here; what stands between backticks is shown as code.
std::string paragraph(std::string_view text);
/// A picture with a line below it.
std::string figure(std::string_view svg, std::string_view caption = {});
/// One entry of a "<dl class=facts>".
std::string fact(std::string_view name, std::string_view value);
/// A coloured box with a list of what must not be missed.
std::string format_note_box(std::string_view title, const std::vector<std::string>& notes);

/// What a kind of page has beside what all have.
struct PageExtras {
  std::string_view style = {};   ///< CSS
  std::string_view script = {};  ///< run at the end
};

/// The whole page, with its style and the script that sorts tables.
std::string page(std::string_view title, std::string_view body, const PageExtras& extras = {});

}  // namespace clast::report_detail

#include "report/html/report_page.hpp"

#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {

std::string make_report_page(std::string_view title, std::string_view body) {
  const std::string style = std::string(assets::report_css) + std::string(assets::map_css);
  const std::string script = std::string(assets::blocks_js) + std::string(assets::map_js);
  return format_page(title, body, {.style = style, .script = script});
}

}  // namespace clast::report_detail

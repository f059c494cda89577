#include "report/html/report_page.hpp"

#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {

std::string report_page(std::string_view title, std::string_view body) {
  return page(title, body, {.style = assets::report_css, .script = assets::blocks_js});
}

}  // namespace clast::report_detail

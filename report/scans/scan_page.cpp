#include "report/scans/scan_page.hpp"

#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {

std::string make_scan_page(std::string_view title, std::string_view body) {
  const std::string style = std::string(assets::scans_css) + std::string(assets::turntable_css);
  return format_page(title, body, {.style = style});
}

}  // namespace clast::report_detail

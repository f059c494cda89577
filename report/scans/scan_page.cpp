#include "report/scans/scan_page.hpp"

#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {

std::string scan_page(std::string_view title, std::string_view body) {
  return page(title, body, {.style = assets::scans_css});
}

}  // namespace clast::report_detail

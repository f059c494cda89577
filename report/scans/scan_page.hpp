#pragma once
/// Frame of pages about scans.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Formats a page with the styles of images and 3-D views.
std::string make_scan_page(std::string_view title, std::string_view body);

}  // namespace clast::report_detail

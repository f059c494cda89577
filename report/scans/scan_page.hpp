#pragma once
/// Frame of pages about scans.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Makes a page about scans, with the styles of images and 3-D views.
std::string make_scan_page(std::string_view title, std::string_view body);

}  // namespace clast::report_detail

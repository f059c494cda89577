#pragma once
/// The frame of a page about a scan.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// `page` with the style of pictures side by side and of turntables.
std::string make_scan_page(std::string_view title, std::string_view body);

}  // namespace clast::report_detail

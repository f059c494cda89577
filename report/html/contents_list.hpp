#pragma once
/// Table of contents of a page.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Formats links to the key results, if `body` has them, and to each section in order.
std::string make_contents_list(std::string_view body);

}  // namespace clast::report_detail

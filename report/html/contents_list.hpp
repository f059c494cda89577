#pragma once
/// Table of contents of a page.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Makes the table of contents of a page: links to the key results and to each section of `body`.
std::string make_contents_list(std::string_view body);

}  // namespace clast::report_detail

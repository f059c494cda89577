#pragma once
/// Frame of pages with maps, diagrams and a scene.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Makes a page with the styles of charts and a script that highlights the block under the pointer
/// in all diagrams.
std::string make_report_page(std::string_view title, std::string_view body);

}  // namespace clast::report_detail

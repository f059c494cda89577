#pragma once
/// The frame of a page with maps, diagrams and a scene.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// `page` with the style of charts and the script that highlights every mark with the same
/// data-block as the one under the pointer.
std::string make_report_page(std::string_view title, std::string_view body);

}  // namespace clast::report_detail

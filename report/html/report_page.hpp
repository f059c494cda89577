#pragma once
/// Frame of pages with maps, diagrams and a scene.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Formats a page with chart styles and a script. The script highlights all marks whose data-block
/// is that of the mark under the pointer.
std::string make_report_page(std::string_view title, std::string_view body);

}  // namespace clast::report_detail

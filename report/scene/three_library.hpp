#pragma once
/// three.js inside a page, for its 3-D views.
#include <filesystem>
#include <string>

namespace clast::report_detail {

/// Where the parts of three.js that a page needs are installed (Debian package libjs-three): the
/// folder that CLAST_THREE names, or the one found when clast was configured.
std::filesystem::path find_three_folder();
bool three_is_installed();

/// The library and what turns a view by dragging, as elements that scripts run with
/// `clastRun("three-code")` and `clastRun("orbit-code")`.
/// @pre  three_is_installed()
std::string three_scripts();

/// That the view was left out, why, and what to do.
/// @param again  what to do after that: "compare again"
std::string explain_missing_three(const std::string& again);

}  // namespace clast::report_detail

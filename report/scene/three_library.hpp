#pragma once
/// Embedding of three.js in a page.
#include <filesystem>
#include <string>

namespace clast::report_detail {

/// Finds the folder of three.js (Debian package libjs-three): that named by CLAST_THREE, or found
/// at configuration.
std::filesystem::path find_three_folder();
bool three_is_installed();

/// Returns three.js and its orbit control as page elements. Scripts execute them with
/// `clastRun("three-code")` and `clastRun("orbit-code")`.
/// @pre  three_is_installed()
std::string three_scripts();

/// Explains that a 3-D view was omitted, and how to install three.js.
/// @param again  last step of the advice, such as "compare again"
std::string explain_missing_three(const std::string& again);

}  // namespace clast::report_detail

#pragma once
/// Embedding of three.js in a page.
#include <filesystem>
#include <string>

namespace clast::report_detail {

/// Finds the folder of three.js (Debian package libjs-three): the value of the environment variable
/// CLAST_THREE, otherwise the folder found when clast was configured.
std::filesystem::path find_three_folder();
bool three_is_installed();

/// Returns the compressed code of three.js and its orbit control as page elements, and the script
/// with `clastOpenRenderer`, by which other scripts of the page load them. The page must contain
/// unpack.js.
/// @pre  three_is_installed()
std::string three_scripts();

/// Explains that a 3-D view was omitted, and how to install three.js.
/// @param again  last step of the advice, such as "compare again"
std::string explain_missing_three(const std::string& again);

}  // namespace clast::report_detail

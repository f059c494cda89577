#pragma once
/// Scripts and data elements of a page.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Formats a script element; sequences that would end it are replaced by equivalent JavaScript.
std::string format_script_element(std::string_view code);

/// Formats an element with JSON data and the given attributes.
std::string format_json_element(const std::string& attributes, std::string json);

/// Formats an element with a compressed text, read by `clastUnpacked(id)` of unpack.js. Libraries
/// and trajectories are most of a report; browsers open it faster if they need not parse them at
/// once.
std::string format_packed_element(const std::string& id, std::string_view text);

/// Returns the folder of an installed library: from the environment variable, or the one found at
/// configuration.
std::string installed_folder(const char* variable, const char* configured);

}  // namespace clast::report_detail

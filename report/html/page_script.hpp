#pragma once
/// Scripts and data elements of a page.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Formats a script element of a page. Replaces sequences that would end it by equivalent
/// JavaScript.
std::string format_script_element(std::string_view code);

/// Formats a page element with JSON data and the given attributes.
std::string format_json_element(const std::string& attributes, std::string json);

/// Formats a page element with a compressed text, which `clastUnpacked(id)` of unpack.js reads.
/// Large texts are compressed, so that pages open faster.
std::string format_packed_element(const std::string& id, std::string_view text);

/// Finds the folder of a JavaScript library. It is named by the environment variable `variable`, or
/// was found at configuration.
std::string find_javascript_folder(const char* variable, const char* configured);

}  // namespace clast::report_detail

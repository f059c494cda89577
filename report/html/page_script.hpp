#pragma once
/// Scripts and data inside a page.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// "<script>code</script>": what would end the element is written in another way, which means the
/// same in strings of JavaScript.
std::string format_script_element(std::string_view code);

/// An element with JSON for scripts to read. `attributes` are of the element.
std::string format_json_element(const std::string& attributes, std::string json);

/// An element with a text that scripts ask for with `clastUnpacked(id)` of unpack.js, deflated:
/// libraries and trajectories are most of a report, and a browser that has not parsed them opens it
/// sooner.
std::string format_packed_element(const std::string& id, std::string_view text);

/// The folder of an installed library: the one that the environment variable names, or
/// else the one that was found when clast was configured.
std::string installed_folder(const char* variable, const char* configured);

}  // namespace clast::report_detail

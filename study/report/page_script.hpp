#pragma once
/// Scripts and data inside a page.
#include <string>

namespace clast {

/// "<script>code</script>": what would end the element is written in another way, which means the
/// same in strings of JavaScript.
std::string script_element(std::string code);

/// An element with JSON for scripts to read. `attributes` are of the element.
std::string json_element(const std::string& attributes, std::string json);

/// The folder of an installed library: the one that the environment variable names, or
/// else the one that was found when clast was configured.
std::string installed_folder(const char* variable, const char* configured);

}  // namespace clast

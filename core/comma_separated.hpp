#pragma once
/// Comma-separated lists for messages and pages.
#include <string>
#include <vector>

namespace clast {

/// Joins names by commas: "plane, ball, cube".
std::string comma_separated(const std::vector<std::string>& names);

}  // namespace clast

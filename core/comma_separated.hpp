#pragma once
/// Names in a row, for messages and pages.
#include <string>
#include <vector>

namespace clast {

/// "plane, ball, cube".
std::string comma_separated(const std::vector<std::string>& names);

}  // namespace clast

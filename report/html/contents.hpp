#pragma once
/// The list of a page's sections, which stays in view.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// A link to the answer, where `body` has one, and to every `section`, in their order.
std::string contents(std::string_view body);

}  // namespace clast::report_detail

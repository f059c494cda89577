#pragma once
/// Glossary of a page: tooltips of technical terms, and a list at the end of the page.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Adds tooltips to the technical terms of a page, and a glossary of these terms at its end.
std::string link_glossary_terms(std::string_view body);

}  // namespace clast::report_detail

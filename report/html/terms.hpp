#pragma once
/// Glossary of a page: tooltips of technical terms, and a list at the end of the page.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Adds a tooltip to the first occurrence of each term in each section, in paragraphs, notes and
/// table heads. Appends a collapsible glossary of the terms used.
std::string link_glossary_terms(std::string_view body);

}  // namespace clast::report_detail

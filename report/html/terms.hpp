#pragma once
/// Glossary of a page: tooltips of technical terms and a list at its end.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// Marks the first occurrence of each term per section in paragraphs, notes and table heads, and
/// appends a collapsible glossary of the terms used.
std::string link_glossary_terms(std::string_view body);

}  // namespace clast::report_detail

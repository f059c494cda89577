#pragma once
/// Words of the field that a page explains: where they stand, when they are pointed at, have the
/// focus or are tapped, and in a list at its end.
#include <string>
#include <string_view>

namespace clast::report_detail {

/// `body` with the first of every term in each section marked, in paragraphs, notes and heads of
/// tables, and with a folded section that explains those that occur.
std::string link_glossary_terms(std::string_view body);

}  // namespace clast::report_detail

#pragma once
/// Rules for the text of the project's files, as functions that list what breaks them.
#include <vector>

#include "tests/architecture/source_tree.hpp"

namespace clast::architecture {

/// Headers that do not start with `#pragma once`.
Findings guard_findings(const SourceFile& file);

/// Absolute paths of one machine.
Findings machine_path_findings(const SourceFile& file);

/// Keys cited in headers, after the at sign, and in documents, in brackets, that `references`
/// (BibTeX) lacks.
Findings citation_findings(const SourceFile& file, const SourceFile& references);

/// Docs comments of headers that do not begin with a noun or a verb (but with "Of", "Where", "What"
/// or a lower-case letter) or that ask a question.
Findings docs_comment_findings(const SourceFile& file);

/// Lines of documents with more than 120 characters.
Findings long_line_findings(const SourceFile& document);

/// Identifiers of headers that have standard terms instead.
Findings renamed_name_findings(const SourceFile& file);

/// Keys that stand twice in a BibTeX file.
Findings repeated_key_findings(const SourceFile& references);

/// Texts of the libraries that name an option of the command line, "--up", and not the field.
Findings flag_findings(const SourceFile& file);

/// Fields that texts of the libraries name between backticks and that `flags`, the program's table,
/// does not translate.
Findings field_findings(const SourceFile& file, const SourceFile& flags);

/// Sources and headers that a document names between backticks and that `tree` lacks.
Findings named_file_findings(const SourceFile& document, const std::vector<SourceFile>& tree);

}  // namespace clast::architecture

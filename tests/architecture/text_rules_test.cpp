// Header guards, paths of one machine, and citations, in every file of the project.
#include "tests/architecture/text_rules.hpp"

#include <gtest/gtest.h>

namespace clast::architecture {
namespace {

const SourceFile& file_of_project(const std::string& path) {
  for (const SourceFile& file : project()) {
    if (file.path == path) return file;
  }
  throw std::runtime_error(path + " is missing");
}

const SourceFile& references() { return file_of_project("docs/references.bib"); }

TEST(TextRules, LibrariesNameFieldsAndNoOptionsOfTheCommandLine) {
  const Findings findings = in_every_file(flag_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, TheProgramKnowsTheOptionOfEveryFieldThatLibrariesName) {
  const SourceFile& flags = file_of_project("app/option_flags.cpp");
  const Findings findings =
      in_every_file([&](const SourceFile& file) { return field_findings(file, flags); });
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, EveryHeaderStartsWithPragmaOnce) {
  const Findings findings = in_every_file(guard_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, NoFileNamesAPathOfOneMachine) {
  const Findings findings = in_every_file(machine_path_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, EveryCitedKeyIsInTheReferences) {
  const Findings findings =
      in_every_file([](const SourceFile& file) { return citation_findings(file, references()); });
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, DocsCommentsBeginWithANounOrAVerb) {
  const Findings findings = in_every_file(docs_comment_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, LinesOfDocumentsHaveAtMost120Characters) {
  const Findings findings = in_every_file(long_line_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, HeadersUseStandardTerms) {
  const Findings findings = in_every_file(renamed_name_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, NoReferenceStandsTwice) {
  const Findings findings = repeated_key_findings(references());
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(TextRules, SourcesThatDocumentsNameExist) {
  const Findings findings =
      in_every_file([](const SourceFile& file) { return named_file_findings(file, project()); });
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

// The rules, applied to made-up files.

TEST(TextRules, DocsCommentWithoutASubjectIsFound) {
  const auto count = [](const std::string& text) {
    return docs_comment_findings(source_file("dem/a.hpp", text)).size();
  };
  EXPECT_EQ(count("/// Of every block.\nint a;\n/// where it is.\nint b;\n"), 2u);
  EXPECT_EQ(count("/// Is it closed?\nbool a();\n"), 1u);
  EXPECT_EQ(count("/// Volume of a block\n/// in its frame.\nint a;  ///< of the block\n"), 0u);
  EXPECT_EQ(count("// Of every block.\n"), 0u);
}

TEST(TextRules, LongLineOfADocumentIsFound) {
  const std::string line(120, 'a');
  EXPECT_TRUE(long_line_findings(source_file("docs/a.md", line + "\n")).empty());
  EXPECT_EQ(long_line_findings(source_file("docs/a.md", "\n" + line + "b\n")),
            Findings{"docs/a.md:2: has 121 characters, 120 at most"});
  EXPECT_TRUE(long_line_findings(source_file("a.cpp", line + line + "\n")).empty());
}

TEST(TextRules, NameThatWasRenamedIsFound) {
  EXPECT_EQ(renamed_name_findings(source_file("dem/a.hpp", "int a;\ndouble drop_ratio();\n")),
            Findings{"dem/a.hpp:2: drop_ratio is called height_length_ratio"});
  EXPECT_TRUE(renamed_name_findings(source_file("dem/a.hpp", "double drop_ratios();\n")).empty());
}

TEST(TextRules, ASourceThatIsGoneIsFoundInTheDocumentThatNamesIt) {
  const std::string text = "See `dem/a.hpp`\nand `dem/b.hpp`.\n";
  EXPECT_EQ(named_file_findings(source_file("docs/a.md", text), {source_file("dem/a.hpp", "")}),
            Findings{"docs/a.md:2: names dem/b.hpp, which is gone"});
}

TEST(TextRules, OptionOfTheCommandLineInALibraryIsFound) {
  const std::string text = "// --up\nthrow InputError(\"use --up\");\nint i = 1; --i;\n";
  ASSERT_EQ(flag_findings(source_file("mesh/a.cpp", text)).size(), 1u);
  EXPECT_TRUE(flag_findings(source_file("mesh/a.cpp", text))[0].starts_with("mesh/a.cpp:2: "));
  EXPECT_TRUE(flag_findings(source_file("app/a.cpp", text)).empty());
  EXPECT_TRUE(flag_findings(source_file("samples/a.cpp", text + "int main() {}\n")).empty());
  EXPECT_TRUE(flag_findings(source_file("mesh/a.cpp", "\"a -- b\"\n")).empty());
}

TEST(TextRules, FieldWithoutAnOptionIsFound) {
  const SourceFile flags = source_file("app/flags.cpp", "{\"up\", \"--up\"},\n");
  const auto findings = [&](const std::string& text) {
    return field_findings(source_file("mesh/a.cpp", text), flags);
  };
  EXPECT_TRUE(findings("throw InputError(\"use `up`\");\n").empty());
  EXPECT_EQ(findings("throw InputError(\"use `down`\");\n").size(), 1u);
}

TEST(TextRules, HeaderWithoutPragmaOnceIsFound) {
  EXPECT_EQ(guard_findings(source_file("dem/a.hpp", "/// A.\n#pragma once\n")),
            Findings{"dem/a.hpp:1: a header starts with #pragma once"});
  EXPECT_EQ(guard_findings(source_file("dem/a.hpp", "")).size(), 1u);
  EXPECT_TRUE(guard_findings(source_file("dem/a.cpp", "int a;\n")).empty());
}

TEST(TextRules, PathOfOneMachineIsFoundWithItsLine) {
  const std::string slash = "/";
  for (const std::string& path :
       {slash + "home/ana/scan.ply", slash + "tmp/out", slash + "work/main", slash + "Users/a"}) {
    const SourceFile file = source_file("samples/a.toml", "[blocks]\nlibrary = \"" + path + "\"\n");
    ASSERT_EQ(machine_path_findings(file).size(), 1u) << path;
    EXPECT_TRUE(machine_path_findings(file)[0].starts_with("samples/a.toml:2: ")) << path;
  }
}

TEST(TextRules, RelativePathsAndAddressesAreNoPathsOfOneMachine) {
  for (const std::string text : {"../home/a", "${CMAKE_BINARY_DIR}/home/a", "frame/mnt/done",
                                 "https://example.org/home/a", "#!/usr/bin/env bash"}) {
    EXPECT_TRUE(machine_path_findings(source_file("a.md", text)).empty()) << text;
  }
}

TEST(TextRules, CitationWithoutReferenceIsFound) {
  const SourceFile bib = source_file("docs/references.bib", "@article{zingg1935,\n}\n");
  EXPECT_EQ(citation_findings(
                source_file("dem/a.hpp", "/// @cite zingg1935\n/// Text. @cite nobody1999\n"), bib),
            Findings{"dem/a.hpp:2: cites nobody1999, which docs/references.bib lacks"});
  EXPECT_EQ(
      citation_findings(source_file("docs/theory.md", "A [zingg1935, nobody1999].\n"), bib).size(),
      1u);
  EXPECT_TRUE(citation_findings(source_file("docs/theory.md", "`[1, 2]`, [L, I, S]"), bib).empty());
}

TEST(TextRules, RepeatedReferenceIsFound) {
  const SourceFile bib =
      source_file("docs/references.bib", "@article{a2000,\n}\n@book{b2000,\n}\n@misc{a2000,\n}\n");
  EXPECT_EQ(repeated_key_findings(bib), Findings{"docs/references.bib:5: key a2000 stands twice"});
}

}  // namespace
}  // namespace clast::architecture

// Header guards, paths of one machine, and citations, in every file of the project.
#include "tests/architecture/text_rules.hpp"

#include <gtest/gtest.h>

namespace clast::architecture {
namespace {

const SourceFile& references() {
  for (const SourceFile& file : project()) {
    if (file.path == "docs/references.bib") return file;
  }
  throw std::runtime_error("docs/references.bib is missing");
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

TEST(TextRules, NoReferenceStandsTwice) {
  const Findings findings = repeated_key_findings(references());
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

// The rules, applied to made-up files.

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

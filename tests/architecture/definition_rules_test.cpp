#include "tests/architecture/definition_rules.hpp"

#include <gtest/gtest.h>

namespace clast::architecture {
namespace {

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (const TypeDefinition& type : type_definitions(source_file("dem/a.hpp", text))) {
    names.push_back(type.name);
  }
  return names;
}

TEST(DefinitionRules, NoTypeOfTheProjectIsDefinedTwice) {
  const Findings findings = repeated_type_findings(project());
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(DefinitionRules, TypesAreFoundWithTheirNamespaces) {
  EXPECT_EQ(
      names_in("namespace a::b {\nstruct P {\n  struct Inner { int x; };\n};\n"
               "template <class T>\nclass Q final : public P {};\nenum class E : int { x };\n}"),
      (std::vector<std::string>{"a::b::P", "a::b::Q", "a::b::E"}));
  EXPECT_EQ(names_in("namespace a {\nstruct W::Impl {\n};\n}"),
            std::vector<std::string>{"a::W::Impl"});
}

TEST(DefinitionRules, WhatDefinesNoTypeOfTheNamespaceIsNotFound) {
  for (const std::string text :
       {"namespace a {\nstruct P;\nP f(struct P p) { return {}; }\n}",
        "namespace {\nstruct P {};\n}",
        "namespace a {\n// struct P {\n/* struct P { */ const char* t = \"struct P {\";\n}",
        "namespace a {\nvoid f() { struct P {}; }\n}"}) {
    EXPECT_TRUE(names_in(text).empty()) << text;
  }
}

TEST(DefinitionRules, ATypeInTwoFilesIsFoundInTheSecond) {
  const std::string text = "namespace clast::detail {\n\nstruct HeightGrid {\n};\n}\n";
  const std::vector<SourceFile> files = {
      source_file("reconstruct/detail/height_grid.hpp", text),
      source_file("terrain/detail/raw_surface.hpp", text),
      source_file("study/a.hpp", "namespace clast::study_detail {\nstruct HeightGrid {};\n}\n")};
  EXPECT_EQ(repeated_type_findings(files),
            Findings{"terrain/detail/raw_surface.hpp:3: clast::detail::HeightGrid is defined in "
                     "reconstruct/detail/height_grid.hpp too"});
}

}  // namespace
}  // namespace clast::architecture

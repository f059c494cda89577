#include "tests/architecture/definition_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

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

TEST(DefinitionRules, NoTwoFilesOfALibraryDefineOneNameInUnnamedNamespaces) {
  const Findings findings = repeated_unnamed_findings(project());
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(DefinitionRules, NamesOfUnnamedNamespacesAreFound) {
  const SourceFile file = source_file(
      "dem/a.cpp",
      "namespace clast {\nconstexpr int kOutside = 1;\nnamespace {\n\n/// A comment; { here.\n"
      "constexpr double kLow = 0.1, kHigh = 0.9;\nconst int kTable[] = {1, 2};\n"
      "using Triangle = TriangleMesh::Triangle;\nnamespace fs = std::filesystem;\n"
      "template <class T, class U>\nT larger(const T& a, const U& b) {\n  int local = 1;\n"
      "  return f(a);\n}\nstruct Cell {\n  int member = 0;\n};\n"
      "bool Cell::inside() const { return true; }\nvoid declared(int x = g(1));\n"
      "std::optional<Vec3> found;\nusing std::swap;\n}  // namespace\nint outside() {}\n}\n");
  std::vector<std::string> names;
  for (const UnnamedScopeName& name : unnamed_scope_names(file)) names.push_back(name.name);
  EXPECT_EQ(names, (std::vector<std::string>{"kLow", "kHigh", "kTable", "Triangle", "fs", "larger",
                                             "Cell", "declared", "found"}));
}

TEST(DefinitionRules, AnUnnamedNameInTwoFilesOfALibraryIsFound) {
  const auto file = [](const std::string& path, const std::string& text) {
    return source_file(path, "namespace {\n" + text + "\n}\n");
  };
  EXPECT_EQ(
      repeated_unnamed_findings({file("dem/a.cpp", "int f(int x) { return x; }"),
                                 file("dem/detail/b.cpp", "\ndouble f(double y) { return y; }")}),
      Findings{"dem/detail/b.cpp:3: f is defined in dem/a.cpp too"});
  EXPECT_EQ(repeated_unnamed_findings(
                {file("dem/a.cpp", "using A = int;"), file("dem/b.cpp", "using A = long;")}),
            Findings{"dem/b.cpp:2: A is defined in dem/a.cpp too"});
  EXPECT_TRUE(repeated_unnamed_findings({file("dem/a.cpp", "using A = int;"),
                                         file("dem/b.cpp", "using A = int;"),
                                         file("reconstruct/photos/c.cpp", "int f();"),
                                         file("reconstruct/d.cpp", "int f();")})
                  .empty());
}

TEST(DefinitionRules, WhatManyPartsNeedIsWrittenOnce) {
  for (const std::string name :
       {"signed_volume", "surface_area", "triangle_area", "counted", "with_digits",
        "sorted_half_edges", "triangle_neighbours", "triangle_components", "manifold_components",
        "corner_fans", "boundary_loops", "weld_targets", "doubled_area_vector", "turn_over",
        "sha256", "cross", "upper_median", "lower_case", "with_largest_component_positive"}) {
    const Findings findings = repeated_function_findings(project(), name);
    EXPECT_TRUE(findings.empty()) << lines(findings);
  }
  EXPECT_TRUE(std::none_of(project().begin(), project().end(), [](const SourceFile& file) {
    return file.path != "core/disjoint_sets.cpp" && file.folder() != "tests" &&
           std::any_of(file.lines.begin(), file.lines.end(), [](const std::string& line) {
             return line.find("parent_[") != std::string::npos;
           });
  })) << "sets joined pair by pair are DisjointSets of core/disjoint_sets.hpp";
}

TEST(DefinitionRules, AFunctionInTwoFilesIsFoundInTheSecond) {
  const std::vector<SourceFile> files = {
      source_file("mesh/a.hpp", "double signed_volume(const TriangleMesh& mesh);\n"),
      source_file("mesh/a.cpp", "double signed_volume(const TriangleMesh& mesh) {\n"),
      source_file("shapes/b.cpp",
                  "namespace {\ndouble signed_volume(const TriangleMesh& m) {\n"
                  "  return signed_volume(m);\n")};
  EXPECT_EQ(repeated_function_findings(files, "signed_volume"),
            Findings{"shapes/b.cpp:2: signed_volume is defined in mesh/a.cpp too"});
}

/// Where ends are ordered that are no edge of a mesh, and where edges are known in another way yet.
const std::set<std::string> kOrdersEnds = {
    "mesh/half_edges.cpp",                           // is where edges are found
    "dem/search/broad_phase.cpp",                    // bodies
    "dem/simulation/detail/contact_pair_table.hpp",  // bodies
    "classify/surface_indices.cpp",                  // the same
    "reconstruct/photos/stereo_pairs.cpp",           // photographs
    "study/campaign/barrier_line.cpp",               // corners of a polyline
};

TEST(DefinitionRules, EdgesAreFoundInOnePlace) {
  const Findings findings = in_every_file([](const SourceFile& file) {
    return file.folder() == "tests" || kOrdersEnds.contains(file.path)
               ? Findings{}
               : ordered_ends_findings(file);
  });
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(DefinitionRules, ASecondEdgeSortIsFound) {
  const std::string lists =
      "for (const auto& t : mesh.triangles) {\n"
      "  sides.push_back({std::min(t[0], t[1]),\n                   std::max(t[0], t[1]), "
      "7});\n}\n";
  EXPECT_EQ(ordered_ends_findings(source_file("shapes/a.cpp", lists)),
            Findings{"shapes/a.cpp:2: the ends t[0], t[1] are ordered by hand"});
  EXPECT_EQ(ordered_ends_findings(source_file("dem/b.hpp", "file(std::minmax(a, b), t);\n")),
            Findings{"dem/b.hpp:1: the ends a, b are ordered by hand"});
  for (const std::string text :
       {"low = std::min(low, z);\nhigh = std::max(high, z);\n",
        "const auto r = std::minmax({a, b});",
        "const double width = std::min(a, b);\nconst double length = std::max(a, b);\n",
        "// std::min(a, b), std::max(a, b)\n",
        "return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x)};"}) {
    EXPECT_TRUE(ordered_ends_findings(source_file("mesh/c.cpp", text)).empty()) << text;
  }
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
      source_file("reconstruct/ground/detail/thin_plate_grid.hpp", text),
      source_file("terrain/raw_surface.hpp", text),
      source_file("study/a.hpp", "namespace clast::study_detail {\nstruct HeightGrid {};\n}\n")};
  EXPECT_EQ(repeated_type_findings(files),
            Findings{"terrain/raw_surface.hpp:3: clast::detail::HeightGrid is defined in "
                     "reconstruct/ground/detail/thin_plate_grid.hpp too"});
}

}  // namespace
}  // namespace clast::architecture

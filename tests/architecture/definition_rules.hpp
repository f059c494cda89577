#pragma once
/// The one definition rule, for types: two types of one name in one namespace, in one program, are
/// undefined behaviour that no compiler of this project reports.
#include "tests/architecture/source_tree.hpp"

namespace clast::architecture {

/// A class, struct or enum with its body, outside of unnamed namespaces and of other types.
struct TypeDefinition {
  std::string name;  ///< with its namespaces: "clast::terrain_detail::HeightGrid"
  std::size_t line = 0;
};

std::vector<TypeDefinition> type_definitions(const SourceFile& file);

/// Types that are defined in more than one file; the first file is where they may be.
Findings repeated_type_findings(const std::vector<SourceFile>& files);

/// A name that an unnamed namespace of a file defines outside of types and functions.
struct UnnamedScopeName {
  std::string name;
  std::string alias;  ///< what it stands for, where it is an alias; else empty
  std::size_t line = 0;
};

std::vector<UnnamedScopeName> unnamed_scope_names(const SourceFile& file);

/// Names that unnamed namespaces of two files of one library define: the build compiles several
/// files of a library as one. An alias may be repeated if it stands for the same.
Findings repeated_unnamed_findings(const std::vector<SourceFile>& files);

/// Functions named `name` that are defined in more than one file, in any namespace: what each part
/// of the program needs is written once. The first file is where it may be.
Findings repeated_function_findings(const std::vector<SourceFile>& files, const std::string& name);

/// Statements that put the two ends of something in order by hand, `std::min(a, b)` and
/// `std::max(a, b)` or `std::minmax(a, b)`: so begins a second search for the edges of a mesh,
/// which `sorted_half_edges` and `edge_key` of mesh/half_edges.hpp are for.
Findings ordered_ends_findings(const SourceFile& file);

}  // namespace clast::architecture

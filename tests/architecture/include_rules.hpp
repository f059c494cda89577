#pragma once
/// The arrows between the folders and the packages of each, as functions that list what breaks
/// them. docs/architecture.md draws the arrows.
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.hpp"

namespace clast::architecture {

/// The part of the project that a file is in: a folder of one library or program, such as "mesh" or
/// "core/files". Other files have their top folder, such as "tests".
std::string part_of(const std::string& path);

/// A header that is installed: of a library, outside `detail/`.
bool is_public_header(const SourceFile& file);

/// Parts of the project that `part` may include, itself among them.
std::set<std::string> reachable(const std::string& part);

/// Includes of project headers along an arrow that is not drawn, or of a test, sample or benchmark.
Findings include_findings(const SourceFile& file);

/// Includes of packages: heavy ones in a public header, or in a folder that the package is not for;
/// files and streams in `dem`.
Findings package_findings(const SourceFile& file);

/// Links of a part's CMakeLists.txt to a part or a package it may not use.
Findings link_findings(const SourceFile& cmake_lists);

/// Includes of a part that the includer's CMakeLists.txt does not link, directly or
/// through others.
Findings unlinked_findings(const std::vector<SourceFile>& tree);

/// Sources and public headers that their part's CMakeLists.txt does not list, which are neither
/// built nor installed.
Findings unlisted_findings(const std::vector<SourceFile>& tree);

}  // namespace clast::architecture

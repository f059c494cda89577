#pragma once
/// Manual pages out of the option tables.
#include <string>
#include <vector>

#include "app/command_tree.hpp"

namespace clast {

struct ManualPage {
  std::string file;  ///< "clast-new-campaign.1"
  std::string text;  ///< in the man macros of roff
};

/// A page of the program and one of each command below it.
/// @param program  whose name and version the pages show, "clast 0.1.0"
std::vector<ManualPage> manual_pages(const CommandEntry& root, const std::string& program);

}  // namespace clast

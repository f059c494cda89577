#pragma once
/// Shell completion out of the option tables.
#include <string>

#include "app/command_tree.hpp"

namespace clast {

/// A script for bash 4 that completes commands, options, values that are one of a few words, and
/// else file names. It needs no other script.
std::string write_bash_completion(const CommandEntry& root);

/// The same for zsh, with descriptions.
std::string write_zsh_completion(const CommandEntry& root);

}  // namespace clast

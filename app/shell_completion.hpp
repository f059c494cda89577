#pragma once
/// Shell completion scripts.
#include <string>

#include "app/command_tree.hpp"

namespace clast {

/// Returns a bash 4 script that completes commands, options, option values and file names. It needs
/// no other scripts.
std::string write_bash_completion(const CommandEntry& root);

/// Returns a zsh completion script with descriptions.
std::string write_zsh_completion(const CommandEntry& root);

}  // namespace clast

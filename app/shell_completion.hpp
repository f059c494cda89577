#pragma once
/// Shell completion scripts.
#include <string>

#include "app/command_tree.hpp"

namespace clast {

/// Returns a bash 4 script that completes commands, options, their values and file names.
std::string make_bash_completion(const CommandEntry& root);

/// Returns a zsh completion script with descriptions.
std::string make_zsh_completion(const CommandEntry& root);

}  // namespace clast

#include "app/shell_completion.hpp"

#include <functional>

namespace clast {

namespace {

/// Calls `visit` with every command and the words that lead to it; of the program none.
void visit_commands(const CommandEntry& command, const std::string& path,
                    const std::function<void(const CommandEntry&, const std::string&)>& visit) {
  visit(command, path);
  for (const CommandEntry& part : command.commands) {
    visit_commands(part, path.empty() ? part.name : path + " " + part.name, visit);
  }
}

/// Quotes in single quotes, as both shells read them.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char character : text) {
    if (character == '\'') {
      result += "'\\''";
    } else {
      result += character;
    }
  }
  return result + "'";
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// The patterns of a case: 'simulate' | 'library merge', with `before` in front of each.
std::string command_patterns(const CommandEntry& root) {
  std::vector<std::string> patterns;
  visit_commands(root, "", [&](const CommandEntry&, const std::string& path) {
    if (path.empty()) return;
    patterns.push_back(quoted(path.find(' ') == path.npos ? " " + path : path));
  });
  return joined(patterns, " | ");
}

std::vector<std::string> names_of(const std::vector<CommandEntry>& commands) {
  std::vector<std::string> names;
  for (const CommandEntry& command : commands) names.push_back(command.name);
  return names;
}

/// Escapes the special characters of an `_arguments` specification.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char character : text) {
    if (character == '[' || character == ']' || character == ':' || character == '\\') {
      result += '\\';
    }
    result += character == '\n' ? ' ' : character;
  }
  return result;
}

std::string zsh_values(const OptionEntry& option) {
  return ":" + zsh_text(option.value) + ":" +
         (option.choices.empty() ? "_files" : "(" + joined(option.choices, " ") + ")");
}

std::string zsh_option(const OptionEntry& option) {
  const std::string description = "[" + zsh_text(option.description) + "]";
  const std::string values = option.value.empty() ? "" : zsh_values(option);
  std::string text;
  for (const std::string& name : option.names) {
    const std::string often = option.repeated ? "*" : "(" + joined(option.names, " ") + ")";
    text += " \\\n        " + quoted(often + name + description + values);
  }
  return text;
}

std::string zsh_command(const CommandEntry& command) {
  std::string text = "_arguments -s";
  for (const OptionEntry& option : command.options) {
    text +=
        option.positional ? " \\\n        " + quoted("*" + zsh_values(option)) : zsh_option(option);
  }
  if (command.commands.empty()) return text;
  std::vector<std::string> parts;
  for (const CommandEntry& part : command.commands) {
    std::string summary;
    for (const char character : part.summary) {
      if (character == '(' || character == ')' || character == ' ' || character == '\'' ||
          character == '"' || character == ':' || character == '\\') {
        summary += '\\';
      }
      summary += character == '\n' ? ' ' : character;
    }
    parts.push_back(part.name + "\\:" + summary);
  }
  return text + " \\\n        " + quoted("1:command:((" + joined(parts, " ") + "))");
}

}  // namespace

std::string make_bash_completion(const CommandEntry& root) {
  const std::string& name = root.name;
  std::string text = "# Completion of " + name + " for bash, written by " + name +
                     " help --completion bash\n_" + name +
                     "() {\n"
                     "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}\n"
                     "  local command= options= words= i\n"
                     "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
                     "    case \"$command ${COMP_WORDS[i]}\" in\n      " +
                     command_patterns(root) +
                     ") command=${command:+$command }${COMP_WORDS[i]} ;;\n"
                     "    esac\n  done\n"
                     "  case $command in\n";
  std::string values;
  visit_commands(root, "", [&](const CommandEntry& command, const std::string& path) {
    std::vector<std::string> options;
    for (const OptionEntry& option : command.options) {
      if (option.positional) continue;
      options.insert(options.end(), option.names.begin(), option.names.end());
      std::vector<std::string> patterns;
      for (const std::string& known : option.names) patterns.push_back(quoted(path + " " + known));
      if (!option.choices.empty()) {
        values += "    " + joined(patterns, " | ") +
                  ") words=" + quoted(joined(option.choices, " ")) + " ;;\n";
      } else if (!option.value.empty()) {
        values += "    " + joined(patterns, " | ") + ") words= options= ;;\n";
      }
    }
    text += "    " + quoted(path) + ") options=" + quoted(joined(options, " ")) +
            " words=" + quoted(joined(names_of(command.commands), " ")) + " ;;\n";
  });
  return text + "  esac\n  case \"$command $prev\" in\n" + values +
         "  esac\n"
         "  if [[ $cur == -* ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$cur\")\n"
         "  elif [[ -n $words ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$cur\")\n"
         "  else\n"
         "    compopt -o filenames 2> /dev/null\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$cur\")\n"
         "  fi\n}\ncomplete -F _" +
         name + " " + name + "\n";
}

std::string make_zsh_completion(const CommandEntry& root) {
  const std::string& name = root.name;
  std::string text = "#compdef " + name + "\n# Completion of " + name + " for zsh, written by " +
                     name + " help --completion zsh\n_" + name +
                     "() {\n"
                     "  local command=\n  integer i n=1\n"
                     "  for ((i = 2; i < CURRENT; i++)); do\n"
                     "    case \"$command ${words[i]}\" in\n      (" +
                     command_patterns(root) +
                     ") command=${command:+$command }${words[i]}; n=$i ;;\n"
                     "    esac\n  done\n"
                     "  words=(\"${(@)words[n,-1]}\")\n  ((CURRENT -= n - 1))\n"
                     "  case $command in\n";
  visit_commands(root, "", [&](const CommandEntry& command, const std::string& path) {
    text += "    (" + quoted(path) + ")\n      " + zsh_command(command) + "\n      ;;\n";
  });
  return text + "  esac\n}\n_" + name + " \"$@\"\n";
}

}  // namespace clast

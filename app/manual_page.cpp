#include "app/manual_page.hpp"

#include <sstream>

namespace clast {

namespace {

/// Text that roff prints as it is.
std::string roff(const std::string& text) {
  std::string result;
  for (const char character : text) {
    if (character == '\\') {
      result += "\\e";
    } else if (character == '-') {
      result += "\\-";
    } else {
      result += character;
    }
  }
  // At the beginning of a line these would be requests.
  if (!result.empty() && (result[0] == '.' || result[0] == '\'')) result.insert(0, "\\&");
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string with_dashes(std::string path) {
  for (char& character : path) {
    if (character == ' ') character = '-';
  }
  return path;
}

std::string upper(std::string text) {
  for (char& character : text) {
    if (character >= 'a' && character <= 'z') character = static_cast<char>(character - 'a' + 'A');
  }
  return text;
}

std::string synopsis(const CommandEntry& command, const std::string& path) {
  std::string line = bold(path);
  for (const OptionEntry& option : command.options) {
    if (option.positional) {
      const std::string dots = option.repeated ? "..." : "";
      line += option.required ? " " + italic(option.value) + dots
                              : " [" + italic(option.value) + dots + "]";
    } else if (option.required) {
      line += " " + bold(option.names.back()) + " " + italic(option.value);
    }
  }
  if (!command.commands.empty()) line += " " + italic("COMMAND");
  return line + " [" + italic("OPTIONS") + "]\n";
}

std::string option_text(const OptionEntry& option) {
  std::string text = ".TP\n";
  if (option.positional) {
    text += italic(option.value);
  } else {
    for (std::size_t i = 0; i < option.names.size(); ++i) {
      text += (i > 0 ? ", " : "") + bold(option.names[i]);
    }
    if (!option.value.empty()) text += " " + italic(option.value);
  }
  text += "\n" + roff(option.description);
  if (!option.choices.empty()) {
    text += "; one of";
    for (std::size_t i = 0; i < option.choices.size(); ++i) {
      text += (i > 0 ? ", " : " ") + bold(option.choices[i]);
    }
  }
  text += ".";
  if (!option.preset.empty()) text += " Default: " + bold(option.preset) + ".";
  if (option.required && !option.positional) text += " Required.";
  return text + "\n";
}

/// Notes in paragraphs, and behind "Example:" what can be typed, line by line.
std::string footer_text(const std::string& footer) {
  std::istringstream lines(footer);
  std::string text, line;
  bool examples = false;
  for (bool first = true; std::getline(lines, line); first = false) {
    if (line.starts_with("Example")) {
      examples = true;
      text += ".SH EXAMPLES\n.nf\n";
      continue;
    }
    if (first) text += ".SH NOTES\n";
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin != line.npos) text += roff(line.substr(begin)) + "\n";
  }
  return text + (examples ? ".fi\n" : "");
}

void add_pages(const CommandEntry& command, const std::string& path, const std::string& program,
               std::vector<ManualPage>& pages) {
  const std::string name = with_dashes(path);
  std::string text = ".TH " + roff(upper(name)) + " 1 \"\" \"" + roff(program) + "\" \"clast\"\n";
  // Lines are not broken within words, nor stretched to one width.
  text += ".nh\n.ad l\n";
  std::string summary = command.summary;
  text += ".SH NAME\n" + roff(name) + " \\- " + roff(summary.substr(0, summary.find('\n'))) + "\n";
  text += ".SH SYNOPSIS\n" + synopsis(command, path);
  if (!command.commands.empty()) {
    text += ".SH COMMANDS\n";
    for (const CommandEntry& part : command.commands) {
      text += ".TP\n" + bold(path + " " + part.name) + "\n" + roff(part.summary) + ".\n";
    }
  }
  text += ".SH OPTIONS\n";
  for (const OptionEntry& option : command.options) text += option_text(option);
  text += footer_text(command.footer);
  const bool root = path.find(' ') == path.npos;
  std::string others;
  for (const CommandEntry& part : command.commands) {
    others += (others.empty() ? "" : ", ") + bold(with_dashes(path + " " + part.name)) + "(1)";
  }
  if (!root) {
    others = bold(with_dashes(path.substr(0, path.rfind(' ')))) + "(1)" +
             (others.empty() ? "" : ", " + others);
  }
  text += ".SH SEE ALSO\n" + others + "\n";
  pages.push_back({name + ".1", text});
  for (const CommandEntry& part : command.commands) {
    add_pages(part, path + " " + part.name, program, pages);
  }
}

}  // namespace

std::vector<ManualPage> manual_pages(const CommandEntry& root, const std::string& program) {
  std::vector<ManualPage> pages;
  add_pages(root, root.name, program, pages);
  return pages;
}

}  // namespace clast

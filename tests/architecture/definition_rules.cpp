#include "tests/architecture/definition_rules.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <regex>

namespace clast::architecture {
namespace {

/// The text of a file with comments and literals blanked; line ends stay.
class Code {
 public:
  explicit Code(const SourceFile& file) {
    for (const std::string& line : file.lines) text_ += line + "\n";
    for (at_ = 0; at_ < text_.size();) skip_one();
  }
  const std::string& text() const { return text_; }

 private:
  bool here(const char* what) const { return text_.compare(at_, std::strlen(what), what) == 0; }

  void blank_to(std::size_t end) {
    for (end = std::min(end, text_.size()); at_ < end; ++at_) {
      if (text_[at_] != '\n') text_[at_] = ' ';
    }
  }

  void skip_one() {
    if (here("//")) return blank_to(text_.find('\n', at_));
    if (here("/*")) return blank_to(after("*/", at_ + 2));
    if (here("R\"")) {
      const std::size_t open = text_.find('(', at_);
      return blank_to(after(")" + text_.substr(at_ + 2, open - at_ - 2) + "\"", open));
    }
    const bool digit_before = at_ > 0 && std::isalnum(static_cast<unsigned char>(text_[at_ - 1]));
    if (here("\"") || (here("'") && !digit_before)) return blank_to(end_of_literal());
    ++at_;
  }

  std::size_t after(const std::string& what, std::size_t from) const {
    const std::size_t found = text_.find(what, from);
    return found == std::string::npos ? found : found + what.size();
  }

  std::size_t end_of_literal() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != text_[at_]) end += text_[end] == '\\' ? 2 : 1;
    return end + 1;
  }

  std::string text_;
  std::size_t at_ = 0;
};

/// What a brace opens, from the text since the last brace or semicolon.
struct Opening {
  bool is_namespace = false;
  std::string name;  ///< of the namespace or type; empty: unnamed, or neither
};

Opening opening(const std::string& before) {
  static const std::regex kNamespace(R"((?:^|\s)namespace(?:\s+([\w:]+))?\s*$)");
  static const std::regex kType(
      R"((?:^|[\s>])(?:struct|class|enum|union)(?:\s+(?:class|struct))?\s+([\w:]+)\s*(?:final\s*)?(?::[^:][^()]*)?$)");
  std::smatch match;
  if (std::regex_search(before, match, kNamespace)) return {true, match[1]};
  if (std::regex_search(before, match, kType)) return {false, match[1]};
  return {};
}

}  // namespace

std::vector<TypeDefinition> type_definitions(const SourceFile& file) {
  std::vector<TypeDefinition> found;
  std::vector<Opening> scopes;
  std::string before;
  std::size_t line = 1;
  const Code code(file);
  for (const char c : code.text()) {
    if (c == '\n') ++line;
    if (c == '{') {
      const Opening next = opening(before);
      std::string name;
      bool named = !next.is_namespace && !next.name.empty();
      for (const Opening& scope : scopes) {
        named = named && scope.is_namespace && !scope.name.empty();
        name += scope.name + "::";
      }
      if (named) found.push_back({name + next.name, line});
      scopes.push_back(next);
    }
    if (c == '}' && !scopes.empty()) scopes.pop_back();
    if (c == '{' || c == '}' || c == ';' || c == '#') {
      before.clear();
    } else {
      before += c;
    }
  }
  return found;
}

Findings repeated_type_findings(const std::vector<SourceFile>& files) {
  std::map<std::string, std::string> first;
  Findings findings;
  for (const SourceFile& file : files) {
    if (!file.is_source()) continue;
    for (const TypeDefinition& type : type_definitions(file)) {
      const auto [entry, is_new] = first.emplace(type.name, file.path);
      if (is_new || entry->second == file.path) continue;
      findings.push_back(
          finding(file, type.line, type.name + " is defined in " + entry->second + " too"));
    }
  }
  return findings;
}

Findings repeated_function_findings(const std::vector<SourceFile>& files, const std::string& name) {
  // A definition begins in the first column with its return type; a declaration ends on its line.
  const std::regex definition(R"(^\w[\w:<>&* ]*[ >&*])" + name + R"(\([^;]*$)");
  Findings findings;
  std::string first;
  for (const SourceFile& file : files) {
    if (!file.is_source() || file.folder() == "tests") continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (!std::regex_match(file.lines[i], definition)) continue;
      if (first.empty()) first = file.path;
      if (first == file.path) continue;
      findings.push_back(finding(file, i + 1, name + " is defined in " + first + " too"));
    }
  }
  return findings;
}

Findings ordered_ends_findings(const SourceFile& file) {
  if (!file.is_source()) return {};
  const Code code(file);
  const std::string& text = code.text();
  Findings findings;
  for (const std::string call : {"std::min(", "std::minmax("}) {
    for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
      const std::size_t begin = at + call.size(), end = text.find_first_of("(){}", begin);
      if (end == std::string::npos || text[end] != ')') continue;
      const std::string ends = text.substr(begin, end + 1 - begin);
      // A pair: nothing between the two but a comma, and the name of what takes the second.
      const std::size_t larger = text.find("std::max(" + ends, end);
      const bool pair = larger < text.find_first_of(";=()", end + 1);
      if (call == "std::min(" && !pair) continue;
      const auto line = static_cast<std::size_t>(
          std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1);
      findings.push_back(finding(
          file, line, "the ends " + ends.substr(0, ends.size() - 1) + " are ordered by hand"));
    }
  }
  return findings;
}

}  // namespace clast::architecture

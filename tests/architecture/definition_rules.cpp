#include "tests/architecture/definition_rules.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <regex>
#include <set>

#include "tests/architecture/include_rules.hpp"

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

/// The names that a statement at the level of a namespace defines, from its text up to the brace or
/// semicolon.
std::vector<UnnamedScopeName> defined_names(const std::string& statement, std::size_t line) {
  static const std::regex kTemplate(R"(^\s*template\s*<[^(){}]*>\s*(?=[A-Za-z_]))");
  static const std::regex kType(
      R"(^\s*(?:struct|class|enum|union)(?:\s+(?:class|struct))?\s+(\w+))");
  static const std::regex kAlias(R"(^\s*(?:using|namespace)\s+(\w+)\s*=\s*([^]*)$)");
  static const std::regex kNoDefinition(R"(^\s*(?:using|static_assert|friend|namespace)\b)");
  static const std::regex kFunction(R"(([\w:~]+)\s*\()");
  static const std::regex kVariable(R"((?:^|[^:\w])(\w+)\s*(?:\[[^\]]*\]\s*)*$)");
  const std::string text = std::regex_replace(statement, kTemplate, "");
  std::smatch match;
  if (std::regex_search(text, match, kType)) return {{match[1], "", line}};
  if (std::regex_search(text, match, kAlias)) return {{match[1], match[2], line}};
  if (std::regex_search(text, kNoDefinition) || text.find("operator") != std::string::npos)
    return {};
  // Template arguments may be signatures: std::function<double(int)>.
  static const std::regex kArguments(R"(<[^<>]*>)");
  std::string before_value = text.substr(0, text.find('='));
  while (std::regex_search(before_value, kArguments)) {
    before_value = std::regex_replace(before_value, kArguments, "");
  }
  if (std::regex_search(before_value, match, kFunction)) {
    const std::string name = match[1];
    if (name.find(':') != std::string::npos) return {};
    return {{name, "", line}};
  }
  if (!std::regex_search(before_value, match, kVariable)) return {};
  std::vector<UnnamedScopeName> names = {{match[1], "", line}};
  static const std::regex kNext(R"(,\s*(k[A-Z]\w*)\s*=)");
  for (std::sregex_iterator next(text.begin(), text.end(), kNext), end; next != end; ++next) {
    names.push_back({(*next)[1], "", line});
  }
  return names;
}

/// The library, or the folder of tests, whose files are compiled together with this one.
std::string library_of(const SourceFile& file) {
  if (file.folder() == "tests") {
    const std::size_t folder = file.path.find('/') + 1;
    return file.path.substr(0, file.path.find('/', folder));
  }
  return part_of(file.path);
}

}  // namespace

std::vector<UnnamedScopeName> unnamed_scope_names(const SourceFile& file) {
  std::vector<UnnamedScopeName> found;
  std::vector<Opening> scopes;
  std::string statement;
  std::size_t line = 1, begin = 1;
  const auto in_unnamed = [&] {
    return std::all_of(scopes.begin(), scopes.end(),
                       [](const Opening& s) { return s.is_namespace; }) &&
           std::any_of(scopes.begin(), scopes.end(),
                       [](const Opening& s) { return s.name.empty(); });
  };
  const auto end_statement = [&] {
    if (in_unnamed()) {
      for (auto& name : defined_names(statement, begin)) found.push_back(std::move(name));
    }
    statement.clear();
  };
  const Code code(file);
  bool directive = false;
  for (const char c : code.text()) {
    if (c == '\n') {
      ++line;
      directive = false;
    }
    directive = directive || c == '#';
    if (directive) continue;
    if (c == '{') {
      const Opening next = opening(statement);
      if (!next.is_namespace) end_statement();
      statement.clear();
      scopes.push_back(next);
    } else if (c == '}') {
      if (!scopes.empty()) scopes.pop_back();
      statement.clear();
    } else if (c == ';') {
      end_statement();
    } else if (!statement.empty() || !std::isspace(static_cast<unsigned char>(c))) {
      if (statement.empty()) begin = line;
      statement += c;
    }
  }
  return found;
}

Findings repeated_unnamed_findings(const std::vector<SourceFile>& files) {
  struct First {
    std::string path, alias;
  };
  // Macros of GoogleTest, and the overloads by which it prints values of a test's own types.
  static const std::set<std::string> kOfEveryTest = {"TEST", "TEST_F", "TEST_P", "PrintTo",
                                                     "INSTANTIATE_TEST_SUITE_P"};
  std::map<std::string, First> first;
  Findings findings;
  for (const SourceFile& file : files) {
    if (!file.path.ends_with(".cpp") || file.folder() == "benchmarks" ||
        file.folder() == "samples" || file.folder() == "docs") {
      continue;
    }
    for (const UnnamedScopeName& name : unnamed_scope_names(file)) {
      const auto [entry, is_new] =
          first.emplace(library_of(file) + " " + name.name, First{file.path, name.alias});
      const First& before = entry->second;
      if (is_new || before.path == file.path || kOfEveryTest.contains(name.name)) continue;
      if (!name.alias.empty() && name.alias == before.alias) continue;
      findings.push_back(
          finding(file, name.line, name.name + " is defined in " + before.path + " too"));
    }
  }
  return findings;
}

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

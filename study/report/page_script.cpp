#include "study/report/page_script.hpp"

#include <cstdlib>

namespace clast {

std::string script_element(std::string code) {
  for (std::size_t at = 0; (at = code.find("</", at)) != std::string::npos; at += 3) {
    code.insert(at + 1, 1, '\\');
  }
  return "<script>" + code + "</script>\n";
}

std::string json_element(const std::string& attributes, std::string json) {
  // A "<" is inside a string wherever it is in JSON, and this is how strings may write it.
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) {
    json.replace(at, 1, "\\u003c");
  }
  return "<script type=\"application/json\" " + attributes + ">" + json + "</script>\n";
}

std::string installed_folder(const char* variable, const char* configured) {
  const char* named = std::getenv(variable);
  return named && *named ? named : configured;
}

}  // namespace clast

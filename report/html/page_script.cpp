#include "report/html/page_script.hpp"

#include <cstdlib>

#include "core/files/png.hpp"

namespace clast::report_detail {
namespace {

constexpr int kDeflateLevel = 6;  // a third of the time of 9, 1 % larger

}  // namespace

std::string format_script_element(std::string_view script) {
  std::string code(script);
  for (std::size_t at = 0; (at = code.find("</", at)) != std::string::npos; at += 3) {
    code.insert(at + 1, 1, '\\');
  }
  return "<script>" + code + "</script>\n";
}

std::string format_json_element(const std::string& attributes, std::string json) {
  // A "<" is inside a string wherever it is in JSON, and this is how strings may write it.
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) {
    json.replace(at, 1, "\\u003c");
  }
  return "<script type=\"application/json\" " + attributes + ">" + json + "</script>\n";
}

std::string format_packed_element(const std::string& id, std::string_view text) {
  return "<script type=\"text/plain\" id=\"" + id + "\">" +
         encode_base64(compress_zlib(text, kDeflateLevel)) + "</script>\n";
}

std::string find_javascript_folder(const char* variable, const char* configured) {
  const char* named = std::getenv(variable);
  return named && *named ? named : configured;
}

}  // namespace clast::report_detail

#include "report/scene/three_library.hpp"

#include "core/files/text_file.hpp"
#include "report/html/assets.hpp"
#include "report/html/page_script.hpp"

namespace clast::report_detail {
namespace {

std::filesystem::path core() { return find_three_folder() / "three.min.js"; }
std::filesystem::path orbit() {
  return find_three_folder() / "examples/js/controls/OrbitControls.js";
}

}  // namespace

std::filesystem::path find_three_folder() {
  return find_javascript_folder("CLAST_THREE", CLAST_THREE_FOLDER);
}

bool three_is_installed() {
  std::error_code code;
  return std::filesystem::exists(core(), code) && std::filesystem::exists(orbit(), code);
}

std::string three_scripts() {
  return format_packed_element("three-code", read_text_file(core())) +
         format_packed_element("orbit-code", read_text_file(orbit())) +
         format_script_element(assets::three_view_js);
}

std::string explain_missing_three(const std::string& again) {
  return "The 3-D view is omitted, because three.js is not in " + find_three_folder().string() +
         ". Install it (on Debian: apt install libjs-three), or name its folder in CLAST_THREE, "
         "and " +
         again + ".";
}

}  // namespace clast::report_detail

#include "report/scene/three_library.hpp"

#include "core/files/text_file.hpp"
#include "report/html/page_script.hpp"

namespace clast::report_detail {
namespace {

std::filesystem::path core() { return three_folder() / "three.min.js"; }
std::filesystem::path orbit() { return three_folder() / "examples/js/controls/OrbitControls.js"; }

}  // namespace

std::filesystem::path three_folder() { return installed_folder("CLAST_THREE", CLAST_THREE_FOLDER); }

bool three_is_installed() {
  std::error_code code;
  return std::filesystem::exists(core(), code) && std::filesystem::exists(orbit(), code);
}

std::string three_scripts() {
  return packed_element("three-code", read_text_file(core())) +
         packed_element("orbit-code", read_text_file(orbit()));
}

std::string no_three_text(const std::string& again) {
  return "The 3-D view was left out: three.js is not in " + three_folder().string() +
         ". Install it (on Debian: apt install libjs-three), or name its folder in CLAST_THREE, "
         "and " +
         again + ".";
}

}  // namespace clast::report_detail

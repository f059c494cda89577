#include "core/files/up_axis.hpp"

#include "core/error.hpp"
#include "core/files/text_file.hpp"

namespace clast {

std::string resolve_up_axis(const std::string& up, const std::filesystem::path& file) {
  if (up == "y" || up == "z") return up;
  if (up != "auto") {
    throw InputError("up = \"" + up + "\"; must be \"y\", \"z\" or \"auto\"");
  }
  const std::string extension = lower_case_extension(file);
  return extension == ".glb" || extension == ".gltf" ? "y" : "z";
}

}  // namespace clast

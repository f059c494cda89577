#include "mesh/ply_properties.hpp"

#include "core/error_context.hpp"
#include "core/files/text_file.hpp"
#include "mesh/detail/mesh_readers.hpp"

namespace clast {

std::vector<std::vector<double>> read_ply_vertex_properties(const std::filesystem::path& path,
                                                            const std::vector<std::string>& names) {
  return with_error_context(path.string(), [&] {
    return mesh_detail::read_ply_vertex_values(read_text_file(path), names);
  });
}

}  // namespace clast

#pragma once
/// Encoders of the mesh formats of `write_mesh`.
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace clast::mesh_detail {

std::string encode_stl(const TriangleMesh& mesh);  ///< binary, single precision
std::string encode_obj(const TriangleMesh& mesh);  ///< shortest digits that restore each double
std::string encode_ply(const TriangleMesh& mesh);  ///< binary little endian, double precision
std::string encode_glb(const TriangleMesh& mesh);  ///< binary glTF 2.0, single precision
std::string encode_vtp(const TriangleMesh& mesh);  ///< VTK XML PolyData as text, double precision

}  // namespace clast::mesh_detail

#pragma once
/// The bytes of a mesh file in each format that `write_mesh` knows.
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace clast::mesh_detail {

std::string stl_content(const TriangleMesh& mesh);  ///< binary, single precision
std::string obj_content(const TriangleMesh& mesh);  ///< shortest text that reads back the same
std::string ply_content(const TriangleMesh& mesh);  ///< binary little endian, double precision
std::string glb_content(const TriangleMesh& mesh);  ///< binary glTF 2.0, single precision
std::string vtp_content(const TriangleMesh& mesh);  ///< VTK XML PolyData as text, double precision

}  // namespace clast::mesh_detail

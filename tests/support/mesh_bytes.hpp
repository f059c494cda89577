#pragma once
/// A mesh as the bytes of a file of any format that is read, for tests of the readers.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "core/files/text_file.hpp"
#include "mesh/mesh_io.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

namespace mesh_bytes {

inline std::string line(const char* format, double x, double y, double z) {
  char text[120];
  std::snprintf(text, sizeof text, format, x, y, z);
  return text;
}

inline std::string written(const TriangleMesh& mesh, const std::string& name) {
  const ScratchFolder folder;
  write_mesh(folder / name, mesh);
  return read_text_file(folder / name);
}

inline std::string ascii_ply(const TriangleMesh& mesh) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " +
                     std::to_string(mesh.vertices.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(mesh.triangles.size()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& v : mesh.vertices) text += line("%.7g %.7g %.7g\n", v.x(), v.y(), v.z());
  for (const auto& [a, b, c] : mesh.triangles) text += line("3 %.0f %.0f %.0f\n", a, b, c);
  return text;
}

inline std::string ascii_stl(const TriangleMesh& mesh) {
  std::string text = "solid rock\n";
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : t) {
      const Vec3& p = mesh.vertices[v];
      text += line("vertex %.7g %.7g %.7g\n", p.x(), p.y(), p.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid rock\n";
}

inline std::string off(const TriangleMesh& mesh) {
  std::string text = "OFF\n" + std::to_string(mesh.vertices.size()) + " " +
                     std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& v : mesh.vertices) text += line("%.7g %.7g %.7g\n", v.x(), v.y(), v.z());
  for (const auto& [a, b, c] : mesh.triangles) text += line("3 %.0f %.0f %.0f\n", a, b, c);
  return text;
}

inline std::string tab(const TriangleMesh& mesh) {
  std::string text;
  for (const Vec3& v : mesh.vertices) text += line("v %.7g %.7g %.7g\n", v.x(), v.y(), v.z());
  for (const auto& [a, b, c] : mesh.triangles) text += line("f %.0f %.0f %.0f\n", a, b, c);
  return text;
}

/// The chunk format of 3D Studio: 16-bit name, 32-bit length of all, content; little-endian.
inline std::string chunk(std::uint16_t name, const std::string& content) {
  const auto length = static_cast<std::uint32_t>(6 + content.size());
  std::string bytes(6, '\0');
  std::memcpy(bytes.data(), &name, 2);
  std::memcpy(bytes.data() + 2, &length, 4);
  return bytes + content;
}

inline std::string three_ds(const TriangleMesh& mesh) {
  const auto put = [](std::string& bytes, auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  std::string points, faces;
  put(points, static_cast<std::uint16_t>(mesh.vertices.size()));
  for (const Vec3& v : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) put(points, static_cast<float>(v[axis]));
  }
  put(faces, static_cast<std::uint16_t>(mesh.triangles.size()));
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) put(faces, static_cast<std::uint16_t>(v));
    put(faces, std::uint16_t{0});
  }
  const std::string solid = chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, faces));
  return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, std::string("rock\0", 5) + solid)));
}

inline std::string base64(const std::string& bytes) {
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (int shift = 18; shift >= 0; shift -= 6) text += digits[three >> shift & 63u];
  }
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

/// The JSON of a GLB file with its binary part as a data URI.
inline std::string gltf(const TriangleMesh& mesh) {
  const std::string glb = written(mesh, "rock.glb");
  std::uint32_t json_length = 0, binary_length = 0;
  std::memcpy(&json_length, glb.data() + 12, 4);
  std::memcpy(&binary_length, glb.data() + 20 + json_length, 4);
  std::string json = glb.substr(20, json_length);
  const std::string binary = glb.substr(28 + json_length, binary_length);
  const std::string key = "\"buffers\":[{";
  const std::size_t where = json.find(key);
  json.insert(where + key.size(),
              "\"uri\":\"data:application/octet-stream;base64," + base64(binary) + "\",");
  return json;
}

}  // namespace mesh_bytes

struct MeshFile {
  std::string name;  ///< with the extension
  std::string bytes;
};

/// The mesh, of less than 65,536 vertices, in every format and both kinds of each.
inline std::vector<MeshFile> mesh_files(const TriangleMesh& mesh) {
  return {{"rock.obj", mesh_bytes::written(mesh, "rock.obj")},
          {"binary.ply", mesh_bytes::written(mesh, "rock.ply")},
          {"text.ply", mesh_bytes::ascii_ply(mesh)},
          {"binary.stl", mesh_bytes::written(mesh, "rock.stl")},
          {"text.stl", mesh_bytes::ascii_stl(mesh)},
          {"rock.off", mesh_bytes::off(mesh)},
          {"rock.tab", mesh_bytes::tab(mesh)},
          {"rock.glb", mesh_bytes::written(mesh, "rock.glb")},
          {"rock.gltf", mesh_bytes::gltf(mesh)},
          {"rock.3ds", mesh_bytes::three_ds(mesh)}};
}

}  // namespace clast

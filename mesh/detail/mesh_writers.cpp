#include "mesh/detail/mesh_writers.hpp"

#include <array>
#include <charconv>

#include "mesh/detail/little_endian.hpp"

namespace clast::mesh_detail {

namespace {

template <class T>
void append_text(std::string& text, T value) {
  std::array<char, 32> buffer;
  const auto [end, code] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end);
}

void append_floats(std::string& bytes, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, static_cast<float>(v[axis]));
}

void append_point_text(std::string& text, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) text += ' ';
    append_text(text, v[axis]);
  }
}

}  // namespace

std::string encode_stl(const TriangleMesh& mesh) {
  std::string bytes = "binary STL written by clast";  // must not start with "solid"
  bytes.resize(80, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    append_floats(bytes, (b - a).cross(c - a).normalized());
    for (const Vec3* corner : {&a, &b, &c}) append_floats(bytes, *corner);
    append_little_endian(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string encode_obj(const TriangleMesh& mesh) {
  std::string text = "# written by clast, lengths in metres\n";
  for (const Vec3& v : mesh.vertices) {
    text += "v ";
    append_point_text(text, v);
    text += '\n';
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t corner : t) {
      text += ' ';
      append_text(text, std::uint64_t{corner} + 1);
    }
    text += '\n';
  }
  return text;
}

std::string encode_ply(const TriangleMesh& mesh) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\ncomment written by clast, lengths in metres\n"
      "element vertex " +
      std::to_string(mesh.vertices.size()) +
      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
      std::to_string(mesh.triangles.size()) +
      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& v : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, v[axis]);
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    bytes += '\3';
    for (const std::uint32_t corner : t) {
      append_little_endian(bytes, static_cast<std::int32_t>(corner));
    }
  }
  return bytes;
}

std::string encode_glb(const TriangleMesh& mesh) {
  std::string buffer;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) append_little_endian(buffer, corner);
  }
  const std::size_t index_bytes = buffer.size();
  for (const Vec3& v : mesh.vertices) append_floats(buffer, v);
  const std::size_t vertex_bytes = buffer.size() - index_bytes;

  // glTF wants the bounds of positions exactly as stored, that is after rounding to float.
  const Bounds box = bounds(mesh);
  const auto bound_text = [](const Vec3& v) {
    std::string text = "[";
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) text += ',';
      append_text(text, static_cast<float>(v[axis]));
    }
    return text + "]";
  };
  const auto view = [](std::size_t offset, std::size_t length, const char* target) {
    return "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
           ",\"byteLength\":" + std::to_string(length) + ",\"target\":" + target + "}";
  };
  std::string json =
      "{\"asset\":{\"version\":\"2.0\",\"generator\":\"clast\"},\"scene\":0,"
      "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
      "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],"
      "\"buffers\":[{\"byteLength\":" +
      std::to_string(buffer.size()) + "}],\"bufferViews\":[" + view(0, index_bytes, "34963") + "," +
      view(index_bytes, vertex_bytes, "34962") +
      "],\"accessors\":[{\"bufferView\":0,\"componentType\":5125,\"type\":\"SCALAR\",\"count\":" +
      std::to_string(3 * mesh.triangles.size()) +
      "},{\"bufferView\":1,\"componentType\":5126,\"type\":\"VEC3\",\"count\":" +
      std::to_string(mesh.vertices.size()) + ",\"min\":" + bound_text(box.low) +
      ",\"max\":" + bound_text(box.high) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');

  std::string bytes = "glTF";
  append_little_endian(bytes, std::uint32_t{2});
  append_little_endian(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  append_little_endian(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append_little_endian(bytes, static_cast<std::uint32_t>(buffer.size()));
  bytes.append("BIN\0", 4);
  return bytes + buffer;
}

std::string encode_vtp(const TriangleMesh& mesh) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"" +
      std::to_string(mesh.vertices.size()) +
      "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
      std::to_string(mesh.triangles.size()) +
      "\">\n<Points>\n"
      "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Vec3& v : mesh.vertices) {
    append_point_text(text, v);
    text += '\n';
  }
  text +=
      "</DataArray>\n</Points>\n<Polys>\n"
      "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      append_text(text, corner);
      text += ' ';
    }
    text += '\n';
  }
  text += "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t t = 1; t <= mesh.triangles.size(); ++t) {
    append_text(text, 3 * t);
    text += '\n';
  }
  return text + "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace clast::mesh_detail

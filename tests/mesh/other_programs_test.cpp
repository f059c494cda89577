// Meshes as other programs write them, with what they add and leave out.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "core/files/text_file.hpp"
#include "mesh/mesh_io.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

constexpr double kVolume = 1.0 * 0.8 * 0.5;

/// A box of 1 x 0.8 x 0.5 m with its six sides as quadrilaterals, from 0.
struct Box {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 4>> quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::vector<std::array<int, 3>> triangles;

  Box() {
    for (int k = 0; k < 8; ++k)
      vertices.emplace_back(k & 1, 0.8 * (k >> 1 & 1), 0.5 * (k >> 2 & 1));
    for (const auto& [a, b, c, d] : quads) {
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
};

std::string numbers(const Vec3& v) {
  return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
}

template <class T>
std::string bytes_of(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

class OtherPrograms : public testing::Test {
 protected:
  void expect_box(const std::string& name, const std::string& content) {
    write_text_file(folder_ / name, content);
    double volume = 0.0;
    const std::string message =
        refusal([&] { volume = std::abs(signed_volume(read_mesh(folder_ / name))); });
    EXPECT_NEAR(volume, kVolume, 1e-6) << message << "\n" << content.substr(0, 400);
  }
  std::string refused(const std::string& name, const std::string& content) {
    write_text_file(folder_ / name, content);
    return refusal([&] { read_mesh(folder_ / name); });
  }
  const Box box_;
  ScratchFolder folder_;
};

class OtherStl : public OtherPrograms {
 protected:
  /// @param head  of at most 80 bytes, filled with `fill`
  std::string binary(std::string head, char fill, std::uint32_t count, const std::string& tail) {
    head.resize(80, fill);
    std::string file = head + bytes_of(count);
    for (const auto& triangle : box_.triangles) {
      file += std::string(12, '\0');
      for (const int v : triangle) {
        for (const double x : box_.vertices[static_cast<std::size_t>(v)]) {
          file += bytes_of(static_cast<float>(x));
        }
      }
      file += std::string(2, '\0');
    }
    return file + tail;
  }
  std::string ascii(const std::string& end = "\n") {
    std::string text = "solid block" + end;
    for (const auto& triangle : box_.triangles) {
      text += "facet normal 0 0 0" + end + "outer loop" + end;
      for (const int v : triangle) {
        text += "vertex " + numbers(box_.vertices[static_cast<std::size_t>(v)]) + end;
      }
      text += "endloop" + end + "endfacet" + end;
    }
    return text + "endsolid" + end;
  }
};

TEST_F(OtherStl, BinaryFilesAreKnownByTheirBytesWhateverTheirHeadSays) {
  for (const char* head :
       {"solid block", "solid", "block", "SOLID by CAD", "solid facet normal", ""}) {
    for (const char fill : {' ', '\0', 'x'}) {
      for (const char* tail : {"", "\n", "\r\n", "\x1a", "made by hand, 12 facets"}) {
        expect_box("a.stl", binary(head, fill, 12, tail));
      }
    }
  }
  EXPECT_TRUE(contains(refused("a.stl", binary("solid block", ' ', 13, "")), "cut short"));
  EXPECT_TRUE(contains(refused("a.stl", binary("block", ' ', 0, "")), "says 0 triangles"));
  EXPECT_TRUE(contains(refused("a.stl", binary("solid block", ' ', 0, "")), "says 0 triangles"));
}

TEST_F(OtherStl, TextMayBeginWithBlanksLinesAndMarks) {
  for (const char* before :
       {"", " ", "\n", "\r\n\r\n", "\t \n", "\xEF\xBB\xBF", "\xEF\xBB\xBF\n"}) {
    for (const char* end : {"\n", "\r\n", "\r", " \n"}) expect_box("a.stl", before + ascii(end));
  }
  const std::string text = ascii();
  expect_box("b.stl", text.substr(text.find("facet")));  // without its first line
  expect_box("c.stl", text.substr(0, text.find("endsolid")));
  std::string capitals = text;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_box("d.stl", "\n" + capitals);
}

class OtherObj : public OtherPrograms {
 protected:
  /// @param vertex, face  write one line from its number and its words
  std::string text(const std::function<std::string(int, const std::vector<std::string>&)>& vertex,
                   const std::function<std::string(int, const std::vector<std::string>&)>& face) {
    std::string file;
    for (std::size_t v = 0; v < box_.vertices.size(); ++v) {
      const Vec3& p = box_.vertices[v];
      file += vertex(static_cast<int>(v),
                     {std::to_string(p.x()), std::to_string(p.y()), std::to_string(p.z())});
    }
    for (std::size_t q = 0; q < box_.quads.size(); ++q) {
      std::vector<std::string> corners;
      for (const int v : box_.quads[q]) corners.push_back(std::to_string(v + 1));
      file += face(static_cast<int>(q), corners);
    }
    return file;
  }
};

TEST_F(OtherObj, RemarksAndContinuedLinesStandAnywhere) {
  const auto plain = [](const char* keyword, const char* end) {
    return [=](int, const std::vector<std::string>& words) {
      std::string line = keyword;
      for (const std::string& word : words) line += " " + word;
      return line + end;
    };
  };
  /// Broken behind the word `at`.
  const auto broken = [](const char* keyword, std::size_t at, const char* with, const char* end) {
    return [=](int, const std::vector<std::string>& words) {
      std::string line = keyword;
      for (std::size_t k = 0; k < words.size(); ++k) line += (k == at ? with : " ") + words[k];
      return line + end;
    };
  };
  for (const char* end :
       {"\n", "\r\n", " # side\n", " #\n", " # C:\\\n", "\t# 1 2 3\r\n", "\n\n"}) {
    expect_box("a.obj", text(plain("v", end), plain("f", end)));
    for (const char* with : {" \\\n", "\\\n ", " \\\r\n", "\\\r\n  ", " \\\n\t", " \\\n \\\n "}) {
      for (std::size_t at = 0; at < 3; ++at) {
        expect_box("b.obj", text(broken("v", at, with, end), plain("f", end)));
        expect_box("c.obj", text(plain("v", end), broken("f", at, with, end)));
        expect_box("d.obj", text(broken("v", at, with, end), broken("f", at + 1, with, end)));
      }
    }
  }
  expect_box("e.obj",
             "# C:\\\nmtllib C:\\rocks\\\ng side\\\n" + text(plain("v", "\n"), plain("f", "\n")));
  expect_box("f.obj", text(plain("v", " 0.5 0.5 0.5 # grey\n"), plain("f", "\n")));
  expect_box("g.obj", text(plain("v", "\n"), plain("fo", "\n")));
}

TEST_F(OtherObj, LineNumbersOfMessagesCountEveryLine) {
  EXPECT_TRUE(
      contains(refused("a.obj", "v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n\\\n3\nf 1 2 x\n"),
               "a.obj: line 8: \"x\" is not a vertex number"));
}

TEST_F(OtherObj, FreeFormSurfacesAreRefusedByName) {
  EXPECT_TRUE(
      contains(refused("a.obj", "v 0 0 0\nv 1 0 0\ncstype bspline\ndeg 3 3\nsurf 0 1 0 1 1 2\n"),
               "line 3: \"cstype\" begins a free-form curve or surface"));
}

class OtherPlyAndOff : public OtherPrograms {
 protected:
  std::string ply(const std::string& properties, const std::string& after_vertex,
                  const std::string& after_face, const std::string& face_properties = "") {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
        "property float z\n" +
        properties +
        "element face 6\nproperty list uchar int "
        "vertex_indices\n" +
        face_properties + "end_header\n";
    for (const Vec3& v : box_.vertices) text += numbers(v) + after_vertex + "\n";
    for (const auto& [a, b, c, d] : box_.quads) {
      text += "4 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " +
              std::to_string(d) + after_face + "\n";
    }
    return text;
  }
  std::string off(const std::string& head, const std::string& after_vertex,
                  const std::string& after_face) {
    std::string text = head;
    for (const Vec3& v : box_.vertices) text += numbers(v) + after_vertex + "\n";
    for (const auto& [a, b, c, d] : box_.quads) {
      text += "4 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " +
              std::to_string(d) + after_face + "\n";
    }
    return text;
  }
};

TEST_F(OtherPlyAndOff, NumbersBeyondTheCountOfALineAreColours) {
  for (const char* colours : {"", " 255 0 0", " 0.5 0.5 0.5 1.0", " 128", "  "}) {
    expect_box("a.ply", ply("", "", colours));
    expect_box("b.ply", ply("", colours, ""));
    expect_box("c.ply", ply("property uchar red\n", " 7", colours, ""));
    expect_box("d.ply", ply("", colours, colours));
    expect_box("e.off", off("OFF\n8 6 12\n", "", colours));
    expect_box("f.off", off("OFF 8 6 12\n", colours, colours));
    expect_box("g.off", off("COFF\n8 6 0\n", " 255 255 255 255", colours));
  }
  std::string capitals = ply("", "", "");
  for (const char axis : {'x', 'y', 'z'}) {
    const std::string property = std::string("property float ") + axis;
    capitals[capitals.find(property) + property.size() - 1] = static_cast<char>(axis - 'a' + 'A');
  }
  expect_box("j.ply", capitals);
  // Elements that do not have a line each are read number by number.
  std::string one_line = ply("", "", "");
  const std::size_t body = one_line.find("end_header\n") + 11;
  for (std::size_t i = body; i < one_line.size(); ++i) {
    if (one_line[i] == '\n') one_line[i] = ' ';
  }
  expect_box("h.ply", one_line);
  std::string short_line = ply("", "", " 255 0 0");
  const std::size_t third = short_line.find("4 0 1 5 4");
  short_line.erase(third + 5, 4);
  short_line.replace(third, 1, "9");
  EXPECT_TRUE(contains(refused("i.ply", short_line), "holds fewer numbers than the header says"));
}

TEST_F(OtherPlyAndOff, NumbersOfMicrosoftThatAreNotFiniteAreRead) {
  for (const char* number : {"-1.#IND", "1.#QNAN", "1.#INF", "-1.#INF00", "nan", "-nan",
                             "-nan(ind)", "NaN", "1.#SNAN", "-1.#IND00", "inf"}) {
    expect_box("a.ply", ply("property float nx\n", std::string(" ") + number, ""));
  }
  EXPECT_TRUE(
      contains(refused("b.ply", ply("property float nx\n", " 1.#WHAT", "")), "is not a number"));
  std::string coordinate = ply("", "", "");
  const std::size_t first = coordinate.find("0.000000");
  coordinate.replace(first, 8, "-1.#IND ");
  EXPECT_TRUE(contains(refused("c.ply", coordinate), "not a finite point"));
}

class OtherGltf : public OtherPrograms {
 protected:
  struct Parts {
    std::string extensions;  ///< members of the file, each with a comma behind it
    std::string accessor = R"("bufferView":0,"componentType":5126,)";
    bool quantised = false;
  };
  std::string json(const Parts& parts, std::size_t positions, std::size_t size,
                   const std::string& uri) {
    return R"({"asset":{"version":"2.0"},)" + parts.extensions +
           R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" +
           (parts.quantised ? R"(,"scale":[0.001,0.001,0.001])" : "") +
           R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("accessors":[{)" +
           parts.accessor +
           R"("count":8,"type":"VEC3","min":[0,0,0],"max":[1000,800,500]},)"
           R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" +
           std::to_string(positions) + (parts.quantised ? R"(,"byteStride":8)" : "") +
           R"(},{"buffer":0,"byteOffset":)" + std::to_string(positions) +
           R"(,"byteLength":72}],"buffers":[{"byteLength":)" + std::to_string(size) + uri + "}]}";
  }
  std::string glb(const Parts& parts) {
    std::string positions, indices;
    for (const Vec3& v : box_.vertices) {
      if (parts.quantised) {
        for (const double x : {v.x(), v.y(), v.z(), 0.0}) {
          positions += bytes_of(static_cast<std::uint16_t>(std::lround(1000.0 * x)));
        }
      } else {
        for (const double x : v) positions += bytes_of(static_cast<float>(x));
      }
    }
    for (const auto& triangle : box_.triangles) {
      for (const int v : triangle) indices += bytes_of(static_cast<std::uint16_t>(v));
    }
    const std::string buffer = positions + indices;
    std::string text = json(parts, positions.size(), buffer.size(), "");
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return "glTF" + bytes_of(std::uint32_t{2}) +
           bytes_of(static_cast<std::uint32_t>(28 + text.size() + buffer.size())) +
           bytes_of(static_cast<std::uint32_t>(text.size())) + "JSON" + text +
           bytes_of(static_cast<std::uint32_t>(buffer.size())) + std::string("BIN\0", 4) + buffer;
  }
  static std::string extension(const char* key, const std::string& name) {
    return "\"" + std::string(key) + "\":[\"" + name + "\"],";
  }
};

TEST_F(OtherGltf, WithoutExtensionsOrWithThoseOfLooksIsRead) {
  expect_box("a.glb", glb({}));
  for (const char* name : {"KHR_materials_unlit", "KHR_texture_transform", "KHR_lights_punctual",
                           "EXT_texture_webp", "KHR_materials_pbrSpecularGlossiness"}) {
    for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
      expect_box("b.glb", glb({.extensions = extension(key, name)}));
    }
  }
  expect_box("c.glb", glb({.extensions = extension("extensionsUsed", "VENDOR_anything")}));
}

TEST_F(OtherGltf, ExtensionsThatShapesNeedAreRefusedByName) {
  for (const char* name :
       {"KHR_mesh_quantization", "EXT_meshopt_compression", "KHR_meshopt_compression",
        "KHR_draco_mesh_compression", "EXT_mesh_gpu_instancing", "CESIUM_RTC", "MSFT_lod",
        "VENDOR_anything"}) {
    const std::string message =
        refused("a.glb", glb({.extensions = extension("extensionsRequired", name)}));
    EXPECT_TRUE(contains(message, "a.glb: its extension " + std::string(name) + " is not read"))
        << name;
    EXPECT_TRUE(contains(message, "save it without that extension")) << name;
  }
  EXPECT_TRUE(contains(
      refused("a.glb", glb({.extensions = extension("extensionsUsed", "EXT_mesh_gpu_instancing")})),
      "EXT_mesh_gpu_instancing is not read"));
  const char* quantised[] = {R"("bufferView":0,"componentType":5123,)",
                             R"("bufferView":0,"componentType":5122,"normalized":true,)",
                             R"("bufferView":0,"componentType":5121,)"};
  for (const char* accessor : quantised) {
    EXPECT_TRUE(
        contains(refused("b.glb", glb({.extensions = "", .accessor = accessor, .quantised = true})),
                 "b.glb: its extension KHR_mesh_quantization is not read: its coordinates are "
                 "whole numbers"));
  }
  EXPECT_TRUE(contains(
      refused("c.glb", glb({.extensions = extension("extensionsUsed", "KHR_draco_mesh_compression"),
                            .accessor = R"("componentType":5126,)"})),
      "has coordinates in compressed form only"));
}

TEST_F(OtherGltf, MeshesThatBonesOrWeightsDeformAreRefused) {
  EXPECT_TRUE(contains(refused("a.glb", glb({.extensions = R"("skins":[{"joints":[0]}],)"})),
                       "has a skin (bones that move the vertices) without inverseBindMatrices"));
  const auto weighted = [&](const std::string& weights) {
    return refused("b.gltf", R"({"asset":{"version":"2.0"},"meshes":[{"weights":[)" + weights +
                                 R"(],"primitives":[]}]})");
  };
  EXPECT_TRUE(contains(weighted("0,1"), "has a morph target with a weight that is not 0"));
  EXPECT_FALSE(contains(weighted("0,0"), "morph target"));
}

}  // namespace
}  // namespace clast

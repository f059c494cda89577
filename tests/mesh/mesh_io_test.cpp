#include "mesh/mesh_io.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/ply_properties.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class MeshFiles : public testing::Test {
 protected:
  TriangleMesh read(const std::string& name, const std::string& content) {
    write_text_file(folder_ / name, content);
    return read_mesh(folder_ / name);
  }
  std::string refused(const std::string& name, const std::string& content) {
    return refusal([&] { read(name, content); });
  }
  ScratchFolder folder_;
};

/// The file names its own path, so that a batch can tell which one it was.
#define EXPECT_REFUSED(name, content, words)                      \
  do {                                                            \
    const std::string message = refused(name, content);           \
    EXPECT_NE(message.find(name), std::string::npos) << message;  \
    EXPECT_NE(message.find(words), std::string::npos) << message; \
  } while (false)

/// A point as single precision keeps it. Through memory: GCC 12 drops a plain double-float-double
/// conversion from Eigen's three-argument constructor when it vectorises.
Vec3 as_floats(const Vec3& v) {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    volatile float stored = static_cast<float>(v[axis]);
    result[axis] = stored;
  }
  return result;
}

TriangleMesh awkward_rock() {
  TriangleMesh rock = random_rock(11, 2);
  for (Vec3& v : rock.vertices) v += Vec3(888600.123456789, 6671300.987654321, 211.75);
  return rock;
}

TEST_F(MeshFiles, ObjAndPlyReadBackEveryBit) {
  const TriangleMesh rock = awkward_rock();
  for (const std::string name : {"rock.obj", "rock.ply"}) {
    write_mesh(folder_ / name, rock);
    const TriangleMesh back = read_mesh(folder_ / name);
    EXPECT_EQ(back.triangles, rock.triangles);
    ASSERT_EQ(back.vertices.size(), rock.vertices.size());
    for (std::size_t v = 0; v < rock.vertices.size(); ++v) {
      EXPECT_EQ(back.vertices[v], rock.vertices[v]);
    }
  }
}

TEST_F(MeshFiles, StlReadsBackItsFloatsTriangleByTriangle) {
  const TriangleMesh rock = random_rock(12, 2);
  write_mesh(folder_ / "rock.stl", rock);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "rock.stl"), 84 + 50 * rock.triangles.size());
  const TriangleMesh back = read_mesh(folder_ / "rock.stl");
  ASSERT_EQ(back.triangles.size(), rock.triangles.size());
  for (std::size_t t = 0; t < rock.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 expected = as_floats(rock.vertices[rock.triangles[t][k]]);
      EXPECT_EQ(back.vertices[back.triangles[t][k]], expected);
    }
  }
}

TEST_F(MeshFiles, GlbIsReadBackByAssimp) {
  const TriangleMesh rock = random_rock(13, 2);
  write_mesh(folder_ / "rock.glb", rock);
  const TriangleMesh back = read_mesh(folder_ / "rock.glb");
  EXPECT_EQ(back.triangles, rock.triangles);
  ASSERT_EQ(back.vertices.size(), rock.vertices.size());
  for (std::size_t v = 0; v < rock.vertices.size(); ++v) {
    EXPECT_EQ(back.vertices[v], as_floats(rock.vertices[v]));
  }
}

// Floats are 0.5 m apart at 6.7e6 m: of a rock of 2 m nothing would be left.
TEST_F(MeshFiles, FloatsFarOutAreWrittenNearAnOriginThatIsTold) {
  const TriangleMesh rock = awkward_rock();
  for (const std::string name : {"far.stl", "far.glb"}) {
    const Vec3 origin = write_mesh(folder_ / name, rock);
    EXPECT_LT((origin - Vec3(888600, 6671301, 212)).cwiseAbs().maxCoeff(), 1.5);
    EXPECT_EQ(origin, origin.array().round().matrix());
    const TriangleMesh back = read_mesh(folder_ / name);
    ASSERT_EQ(back.triangles.size(), rock.triangles.size());
    for (std::size_t t = 0; t < rock.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 place = back.vertices[back.triangles[t][k]] + origin;
        EXPECT_LT((place - rock.vertices[rock.triangles[t][k]]).norm(), 1e-6);
      }
    }
    const std::string told = read_text_file(folder_ / (name + ".origin.txt"));
    EXPECT_TRUE(contains(told, std::to_string(static_cast<int>(origin.x())) + ", "));
  }
  EXPECT_EQ(write_mesh(folder_ / "far.ply", rock), Vec3(Vec3::Zero()));
  EXPECT_EQ(write_mesh(folder_ / "near.stl", random_rock(12, 2)), Vec3(Vec3::Zero()));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "near.stl.origin.txt"));
}

TEST_F(MeshFiles, OriginsAreWrittenAsTheirMeshesAre) {
  const TriangleMesh far = awkward_rock(), near = random_rock(12, 2);
  const std::filesystem::path mesh = folder_ / "a.stl", origin = folder_ / "a.stl.origin.txt";
  const MeshWriteOptions keep{.rules = {.kind = "STL", .replace = false}};
  const MeshWriteOptions replace{.rules = {.kind = "STL"}};
  write_text_file(origin, "of the user");
  for (const TriangleMesh& rock : {far, near}) {
    for (const MeshWriteOptions& output : {MeshWriteOptions{}, keep, replace}) {
      EXPECT_TRUE(contains(refusal([&] { write_mesh(mesh, rock, output); }),
                           "a.stl.origin.txt: already exists and holds \"text\""));
    }
  }
  EXPECT_FALSE(std::filesystem::exists(mesh));
  std::filesystem::remove(origin);
  write_mesh(mesh, far, keep);
  std::filesystem::remove(mesh);
  EXPECT_TRUE(contains(refusal([&] { write_mesh(mesh, near, keep); }),
                       "a.stl.origin.txt: already exists; `replace` replaces it"));
  write_mesh(mesh, near, replace);
  EXPECT_FALSE(std::filesystem::exists(origin)) << "is that of another mesh";
  EXPECT_TRUE(contains(refusal([&] { write_mesh(mesh, far, keep); }), "a.stl: already exists"));
  EXPECT_EQ(read_mesh(mesh).triangles.size(), near.triangles.size());
  EXPECT_FALSE(std::filesystem::exists(origin));
}

TEST_F(MeshFiles, AByteOrderMarkIsNoPartOfTheFirstLine) {
  for (const auto& [name, text] : {std::pair{"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
                                   std::pair{"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
                                   std::pair{"a.tab", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"}}) {
    const TriangleMesh mesh = read(name, std::string("\xEF\xBB\xBF") + text);
    ASSERT_EQ(mesh.vertices.size(), 3u) << name;
    EXPECT_EQ(mesh.triangles.size(), 1u) << name;
    EXPECT_EQ(mesh.vertices[1], Vec3(1, 0, 0)) << name;
  }
}

TEST_F(MeshFiles, VtpHoldsCountsAndTheLastOffset) {
  write_mesh(folder_ / "box.vtp", box_mesh({1, 2, 3}));
  const std::string text = read_text_file(folder_ / "box.vtp");
  EXPECT_NE(text.find("NumberOfPoints=\"8\""), std::string::npos);
  EXPECT_NE(text.find("NumberOfPolys=\"12\""), std::string::npos);
  EXPECT_NE(text.find("\n36\n</DataArray>"), std::string::npos);
}

TEST_F(MeshFiles, AsciiStlIsReadAsDouble) {
  const std::string text =
      "SOLID a\r\n facet normal 0 0 1\r\n  outer loop\r\n   vertex 0.1 888600.123456789 +3e-1\r\n"
      "   vertex 1 0 0\r\n   vertex 0 1 0\r\n  endloop\r\n endfacet\r\nendsolid a\r\n";
  const TriangleMesh mesh = read("a.STL", text);
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.vertices[0], Vec3(0.1, 888600.123456789, 0.3));
}

TEST_F(MeshFiles, BinaryStlMayStartWithSolid) {
  write_mesh(folder_ / "a.stl", tetrahedron());
  std::string bytes = read_text_file(folder_ / "a.stl");
  bytes.replace(0, 6, "solid ");
  EXPECT_EQ(read("b.stl", bytes).triangles.size(), 4u);
}

TEST_F(MeshFiles, ObjKnowsPolygonsSlashesNegativeNumbersColoursAndContinuedLines) {
  const TriangleMesh mesh = read("a.obj",
                                 "mtllib a.mtl\no rock\nv 0 0 0 1 0.5 0.5\nv 1 0 0\nv 1 1 0\nv 0 1 "
                                 "0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3//1 4\nf -4 -3 \\\n -1\n");
  const std::vector<TriangleMesh::Triangle> expected = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}};
  EXPECT_EQ(mesh.triangles, expected);
}

TEST_F(MeshFiles, ConcavePolygonsKeepTheirArea) {
  // An L of area 3 and an arrow-headed quad of area 0.5: fans would cover other ground.
  const TriangleMesh l = read("l.obj",
                              "v 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nv 2 1 0\n"
                              "f 2 3 4 5 6 1\n");
  EXPECT_EQ(l.triangles.size(), 4u);
  EXPECT_DOUBLE_EQ(surface_area(l), 3.0);
  const TriangleMesh arrow = read("q.obj", "v 0 0 0\nv 1 0 0\nv 0.25 0.25 0\nv 0 1 0\nf 2 3 4 1\n");
  EXPECT_DOUBLE_EQ(surface_area(arrow), 0.25);
}

TEST_F(MeshFiles, PlyWithQuadsNormalsColoursConfidenceAndOtherElements) {
  const TriangleMesh mesh =
      read("a.ply",
           "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info x\r\nelement camera 1\r\n"
           "property list uchar float pose\r\nelement vertex 4\r\nproperty float nx\r\n"
           "property double x\r\nproperty double y\r\nproperty double z\r\nproperty uchar red\r\n"
           "property float confidence\r\nelement face 1\r\nproperty uchar flags\r\n"
           "property list uint8 int32 vertex_index\r\nelement edge 0\r\nproperty int a\r\n"
           "end_header\r\n2 0.5 0.5\r\n9 0 0 0 255 0.1\r\n9 1 0 0 255 0.1\r\n9 1 1 0 255 0.1\r\n"
           "9 0 1.123456789012345 0 255 0.1\r\n7 4 0 1 2 3\r\n");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.vertices[3], Vec3(0, 1.123456789012345, 0));
}

/// A tetrahedron as binary PLY with a quad-capable list and a colour, in either byte order.
std::string binary_ply(bool big_endian) {
  std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                      "property float z\nproperty ushort quality\nelement face 4\n"
                      "property list uchar uint vertex_indices\nproperty uchar red\nend_header\n";
  const auto add = [&](auto value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    if (big_endian) std::reverse(raw, raw + sizeof(value));
    bytes.append(raw, sizeof(value));
  };
  for (const Vec3& v : tetrahedron().vertices) {
    for (int axis = 0; axis < 3; ++axis) add(static_cast<float>(v[axis]));
    add(std::uint16_t{0x0102});
  }
  for (const TriangleMesh::Triangle& t : tetrahedron().triangles) {
    add(std::uint8_t{3});
    for (const std::uint32_t corner : t) add(corner);
    add(std::uint8_t{200});
  }
  return bytes;
}

TEST_F(MeshFiles, BinaryPlyInBothByteOrders) {
  for (const bool big_endian : {false, true}) {
    const TriangleMesh mesh = read("a.ply", binary_ply(big_endian));
    EXPECT_EQ(mesh.triangles, tetrahedron().triangles);
    EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
  }
}

TEST_F(MeshFiles, NamedPropertiesOfPlyVerticesAreRead) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement camera 1\nproperty float f\nelement vertex 2\n"
      "property uchar red\nproperty int block\nproperty list uchar int seen\nproperty double X\n"
      "end_header\n";
  const auto read_columns = [&](const std::string& body, const std::vector<std::string>& names) {
    write_text_file(folder_ / "labels.ply", header + body);
    return read_ply_vertex_properties(folder_ / "labels.ply", names);
  };
  const std::string body = "35\n255 7 2 1 4 0.1\n9 -3 0 1e300\n";
  const std::vector<std::vector<double>> expected = {{0.1, 1e300}, {7, -3}};
  EXPECT_EQ(read_columns(body, {"x", "block"}), expected);
  EXPECT_TRUE(contains(refusal([&] { read_columns(body, {"label"}); }),
                       "labels.ply: its vertices have no property \"label\""));
  // A list has no single value.
  EXPECT_TRUE(contains(refusal([&] { read_columns(body, {"seen"}); }), "no property \"seen\""));
  EXPECT_TRUE(
      contains(refusal([&] { read_columns("35\n255 7 2 1 4 0.1\n9", {"x"}); }), "cut short"));
}

TEST_F(MeshFiles, NamedPropertiesOfBinaryPlyInBothByteOrders) {
  for (const bool big_endian : {false, true}) {
    write_text_file(folder_ / "a.ply", binary_ply(big_endian));
    const auto columns = read_ply_vertex_properties(folder_ / "a.ply", {"z", "x"});
    for (std::size_t i = 0; i < tetrahedron().vertices.size(); ++i) {
      EXPECT_EQ(columns[0][i], tetrahedron().vertices[i].z());
      EXPECT_EQ(columns[1][i], tetrahedron().vertices[i].x());
    }
  }
}

TEST_F(MeshFiles, TriangleStripsInPlyBecomeTriangles) {
  const TriangleMesh mesh = read("strip.ply",
                                 "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                                 "property float y\nproperty float z\nelement tristrips 1\n"
                                 "property list int int vertex_indices\nend_header\n"
                                 "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n");
  const std::vector<TriangleMesh::Triangle> expected = {{0, 1, 2}, {2, 1, 3}, {0, 1, 2}};
  EXPECT_EQ(mesh.triangles, expected);
}

TEST_F(MeshFiles, OffWithCommentsColoursAndCountsOnTheFirstLine) {
  const std::string body = "0 0 0 255 0 0\n1 0 0 255 0 0\n\n0 1 0 255 0 0\n3 0 1 2 0.5 0.5 0.5\n";
  EXPECT_EQ(read("a.off", "# rock\nCOFF\n3 1 0\n" + body).triangles.size(), 1u);
  EXPECT_EQ(read("a.off", "OFF 3 1 0\n" + body).triangles.size(), 1u);
}

TEST_F(MeshFiles, AsteroidTablesCountFromZeroOrOne) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::vector<TriangleMesh::Triangle> expected = {{0, 1, 3}};
  EXPECT_EQ(read("a.tab", vertices + "f 0 1 3\n").triangles, expected);
  EXPECT_EQ(read("a.tab", vertices + "f 1 2 4\n").triangles, expected);
}

TEST_F(MeshFiles, NodeTransformsOfAGltfSceneAreApplied) {
  // The same triangle twice: moved, and mirrored (its winding turns so that it still faces +z).
  write_text_file(folder_ / "a.bin", [] {
    std::string bytes;
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) {
      char raw[4];
      std::memcpy(raw, &x, 4);
      bytes.append(raw, 4);
    }
    return bytes;
  }());
  const TriangleMesh mesh = read("a.gltf",
                                 R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
           "nodes":[{"children":[1,2],"translation":[10,0,0]},{"mesh":0,"translation":[0,5,0]},
           {"mesh":0,"scale":[-2,1,1]}],
           "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
           "buffers":[{"uri":"a.bin","byteLength":36}],
           "bufferViews":[{"buffer":0,"byteLength":36}],
           "accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,
           "min":[0,0,0],"max":[1,1,0]}]})");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.vertices[1], Vec3(11, 5, 0));
  Bounds all = bounds(mesh);
  EXPECT_EQ(all.low, Vec3(8, 0, 0));
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    EXPECT_GT((b - a).cross(c - a).z(), 0.0);
  }
}

TEST_F(MeshFiles, MissingEmptyFolderAndUnknownFormatAreRefused) {
  EXPECT_NE(refusal([&] { read_mesh(folder_ / "none.stl"); }).find("no such file"),
            std::string::npos);
  EXPECT_NE(refusal([&] { read_mesh(folder_.path()); }).find("folder"), std::string::npos);
  for (const std::string& extension : readable_mesh_extensions()) {
    EXPECT_REFUSED("empty" + extension, "", "empty");
  }
  EXPECT_REFUSED("photo.jpg", "x", "convert this one first");
  EXPECT_REFUSED("none", "x", ".stl");
}

TEST_F(MeshFiles, NotAMeshIsRefused) {
  const std::string letter = "Dear colleague,\nplease find the blocks attached.\n";
  for (const std::string& extension : readable_mesh_extensions()) {
    const std::string message = refused("letter" + extension, letter);
    EXPECT_NE(message.find("letter" + extension + ": "), std::string::npos) << message;
    EXPECT_GT(message.size(), ("letter" + extension).size() + 25) << message;
  }
  EXPECT_REFUSED("png.stl", "\x89PNG\r\n\x1a\n" + std::string(200, 'x'), "not an STL file");
}

TEST_F(MeshFiles, CoordinatesThatAreNotFiniteNameTheFirstVertex) {
  EXPECT_REFUSED("a.obj", "v 0 0 0\nv 1 nan 0\nv 0 inf 0\nf 1 2 3\n", "vertex 2 of 3");
  EXPECT_REFUSED("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1e999 0\n3 0 1 2\n", "vertex 3 of 3");
  EXPECT_REFUSED("a.tab", "v 0 0 -inf\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "vertex 1 of 3");
  EXPECT_REFUSED("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "end_header\n0 0 0\n1 0 0\n0 NaN 0\n3 0 1 2\n",
                 "vertex 3 of 3");
  write_mesh(folder_ / "t.stl", tetrahedron());
  std::string bytes = read_text_file(folder_ / "t.stl");
  const float nan = std::nanf("");
  std::memcpy(bytes.data() + 84 + 50 + 12, &nan, 4);
  EXPECT_REFUSED("nan.stl", bytes, "vertex 4 of 12");
  TriangleMesh overflow = tetrahedron();
  overflow.vertices[1].x() = 1e200;
  write_mesh(folder_ / "t.glb", overflow);  // infinite as a float
  EXPECT_NE(refusal([&] { read_mesh(folder_ / "t.glb"); }), "");
}

TEST_F(MeshFiles, VertexNumbersOutOfRangeAreRefusedWithTheirLine) {
  EXPECT_REFUSED("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
                 "line 4: a face refers to vertex 4");
  EXPECT_REFUSED("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "line 4");
  EXPECT_REFUSED("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "start at 1");
  EXPECT_REFUSED("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "at least 3");
  EXPECT_REFUSED("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6");
  EXPECT_REFUSED("a.tab", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 3\n", "line 4");
  EXPECT_REFUSED("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n",
                 "face 1: ");
}

TEST_F(MeshFiles, PointCloudsAreNamedAsSuch) {
  EXPECT_REFUSED("a.obj", "v 0 0 0\nv 1 0 0\n", "a point cloud with 2 points and no faces");
  EXPECT_REFUSED("a.off", "OFF\n1 0 0\n0 0 0\n", "a point cloud with 1 points and no faces");
  EXPECT_REFUSED("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n",
                 "a point cloud with 3 points and no faces");
}

TEST_F(MeshFiles, PointsOfACloudThatHaveNoPlaceAreLeftOut) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n";
  write_text_file(folder_ / "cloud.ply", head + "nan nan nan\n1 2 3\n4 5 inf\n");
  const TriangleMesh cloud = read_mesh_or_points(folder_ / "cloud.ply");
  EXPECT_EQ(cloud.vertices, std::vector<Vec3>({Vec3(1, 2, 3)}));
}

TEST_F(MeshFiles, DecimalCommasAreToldOf) {
  EXPECT_TRUE(contains(
      refused("a.stl", "solid a\nfacet normal 0 0 0\nvertex 0,5 0 0\n"),
      "found \"0,5\"; this format requires decimal points, export it with decimal points"));
  EXPECT_TRUE(contains(refused("a.ply",
                               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                               "property float y\nproperty float z\nend_header\n0,5 1 2\n"),
                       "PLY requires decimal points, export it with decimal points"));
}

TEST_F(MeshFiles, CountsThatTheFileCannotHoldAreRefusedWithoutTheMemory) {
  std::string stl = "COL";
  stl.resize(84, '\0');
  stl.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_REFUSED("big.stl", stl, "4294967295 triangles");
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string header = "ply\nformat " + format + " 1.0\n";
    const std::string vertex = "\nproperty float x\nproperty float y\nproperty float z\n";
    EXPECT_REFUSED("big.ply", header + "element vertex 4000000000" + vertex + "end_header\n1 2 3\n",
                   "4000000000 of element \"vertex\"");
    EXPECT_REFUSED("big.ply",
                   header + "element vertex 0" + vertex +
                       "element face 4000000000\nproperty list uchar int vertex_indices\n"
                       "end_header\n1 2 3\n",
                   "4000000000 of element \"face\"");
    EXPECT_REFUSED(
        "big.ply",
        header + "element nothing 9000000000000000000\nelement vertex 0" + vertex + "end_header\n",
        "no vertices");
  }
  EXPECT_REFUSED("list.ply",
                 "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 1\nproperty list uint int vertex_indices\n"
                 "end_header\n4000000000 1 2\n",
                 "list has more entries");
  EXPECT_REFUSED("big.off", "OFF\n4000000000 1 0\n0 0 0\n", "more than the file can hold");
}

TEST_F(MeshFiles, CutShortIsRefused) {
  EXPECT_REFUSED("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
                 "it was cut short; copy it again, or export it anew from the program");
  EXPECT_REFUSED("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "cut short");
  const std::string ply = binary_ply(false);
  EXPECT_REFUSED("a.ply", ply.substr(0, ply.size() - 3), "cut short");
  write_mesh(folder_ / "a.glb", tetrahedron());
  const std::string glb = read_text_file(folder_ / "a.glb");
  EXPECT_NE(refused("b.glb", glb.substr(0, glb.size() - 40)), "");
}

TEST_F(MeshFiles, UnknownOutputFormatAndEmptyMeshAreRefusedAndLeaveNothing) {
  EXPECT_NE(refusal([&] { write_mesh(folder_ / "a.xyz", tetrahedron()); }).find("a.xyz"),
            std::string::npos);
  EXPECT_NE(refusal<GeometryError>([&] { write_mesh(folder_ / "a.stl", {}); }), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

class DamagedFiles : public testing::TestWithParam<std::string> {};

TEST_P(DamagedFiles, AreReadOrRefusedButNeverCrash) {
  const ScratchFolder folder;
  const std::string name = "rock" + GetParam();
  write_mesh(folder / name, random_rock(5, 1));
  const std::string whole = read_text_file(folder / name);
  Random random(17);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged =
        whole.substr(0, i % 2 ? whole.size() : random.uniform_index(whole.size()));
    for (std::uint64_t hits = random.uniform_index(8); hits > 0 && !damaged.empty(); --hits) {
      damaged[random.uniform_index(damaged.size())] = static_cast<char>(random.next_bits());
    }
    write_text_file(folder / name, damaged);
    try {
      inspect_mesh(read_mesh(folder / name));
    } catch (const Error& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
    }
  }
  EXPECT_GT(refused, 50);
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedFiles, testing::Values(".stl", ".obj", ".ply", ".glb"),
                         [](const auto& format) { return format.param.substr(1); });

}  // namespace
}  // namespace clast

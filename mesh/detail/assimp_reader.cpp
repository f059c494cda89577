#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <exception>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "mesh/detail/mesh_readers.hpp"

namespace clast::mesh_detail {

namespace {

using Transform = Eigen::Matrix4d;

Transform to_eigen(const aiMatrix4x4& m) {
  Transform result;
  result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
      m.d3, m.d4;
  return result;
}

void append(TriangleMesh& mesh, const aiMesh& part, const Transform& world_from_part) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const aiVector3D& p = part.mVertices[v];
    mesh.vertices.emplace_back((world_from_part * Eigen::Vector4d(p.x, p.y, p.z, 1.0)).head<3>());
  }
  const bool mirrored = world_from_part.topLeftCorner<3, 3>().determinant() < 0.0;
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;  // points and lines of the scene
    TriangleMesh::Triangle triangle = {first + face.mIndices[0], first + face.mIndices[1],
                                       first + face.mIndices[2]};
    if (mirrored) std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back(triangle);
  }
}

TriangleMesh collected(const aiScene& scene) {
  struct Visit {
    const aiNode* node;
    Transform world_from_parent;
  };
  TriangleMesh mesh;
  std::vector<Visit> open = {{scene.mRootNode, Transform::Identity()}};
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    const Transform world_from_node =
        visit.world_from_parent * to_eigen(visit.node->mTransformation);
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
      append(mesh, *scene.mMeshes[visit.node->mMeshes[i]], world_from_node);
    }
    for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
      open.push_back({visit.node->mChildren[i - 1], world_from_node});
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh read_with_assimp(const std::filesystem::path& path) {
  try {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), aiProcess_Triangulate);
    if (!scene || !scene->mRootNode) {
      throw InputError(std::string("can't be read: ") + importer.GetErrorString());
    }
    return collected(*scene);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(std::string("can't be read: ") + error.what());
  }
}

}  // namespace clast::mesh_detail

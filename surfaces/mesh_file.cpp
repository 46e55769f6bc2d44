#include "surfaces/mesh_file.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "surfaces/tangent_frames.h"
#include "textures/input_error.h"

namespace relievo::surfaces {
namespace {

[[noreturn]] void reject(const std::filesystem::path& file, const std::string& problem) {
    throw textures::InputError(fmt::format("{}: {}", file.string(), problem));
}

// Assimp's messages come in several sentences and lines.
std::string firstSentence(std::string text) {
    text.erase(std::min(text.find_first_of("\r\n"), text.size()));
    while (!text.empty() && (text.back() == '.' || text.back() == ' '))
        text.pop_back();
    return text;
}

const aiScene& import(Assimp::Importer& importer, const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file))
        reject(file, "no such file, expected a mesh");
    if (!importer.IsExtensionSupported(file.extension().string()))
        reject(file,
               "no mesh format that is known, expected OBJ, PLY, glTF or another of assimp's");
    // What differs in other ways than these does not make vertices apart.
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_COLORS | aiComponent_TANGENTS_AND_BITANGENTS |
                                    aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                    aiComponent_TEXTURES | aiComponent_LIGHTS |
                                    aiComponent_CAMERAS);
    const aiScene* const scene =
        importer.ReadFile(file.string(), aiProcess_RemoveComponent | aiProcess_Triangulate |
                                             aiProcess_JoinIdenticalVertices);
    if (scene == nullptr || scene->mRootNode == nullptr)
        reject(file, fmt::format("cannot be read as a mesh ({})",
                                 firstSentence(importer.GetErrorString())));
    return *scene;
}

// z up instead of y.
glm::vec3 turned(const aiVector3D& v) {
    return {v.x, -v.z, v.y};
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Gathers the meshes of a scene.
class MeshGatherer {
  public:
    MeshGatherer(const std::filesystem::path& file, const aiScene& scene,
                 const MeshFileOptions& options)
        : file_(file), scene_(scene), options_(options) {}

    TriangleMesh gather() {
        add(*scene_.mRootNode, aiMatrix4x4());
        return std::move(mesh_);
    }

  private:
    void add(const aiNode& node, const aiMatrix4x4& parent) {
        const aiMatrix4x4 placement = parent * node.mTransformation;
        for (unsigned k = 0; k < node.mNumMeshes; ++k)
            add(*scene_.mMeshes[node.mMeshes[k]], placement);
        for (unsigned k = 0; k < node.mNumChildren; ++k)
            add(*node.mChildren[k], placement);
    }

    // Points and lines are left out.
    void add(const aiMesh& mesh, const aiMatrix4x4& placement) {
        if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0)
            return;
        if (options_.needsUv && !mesh.HasTextureCoords(0))
            reject(file_,
                   "has no texture coordinates, expected some to put a relief or a shape on");
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (unsigned k = 0; k < mesh.mNumVertices; ++k)
            addVertex(mesh, placement, k);
        addNormals(mesh, placement);
        const bool isMirrored = aiMatrix3x3(placement).Determinant() < 0.0f;
        for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
            const aiFace& face = mesh.mFaces[k];
            if (face.mNumIndices != 3)
                continue;
            for (const unsigned corner :
                 isMirrored ? std::array{0u, 2u, 1u} : std::array{0u, 1u, 2u})
                mesh_.indices.push_back(first + face.mIndices[corner]);
        }
    }

    void addVertex(const aiMesh& mesh, const aiMatrix4x4& placement, unsigned number) {
        mesh_.positions.push_back(turned(placement * mesh.mVertices[number]));
        glm::vec2 uv(0.0f);
        if (mesh.HasTextureCoords(0)) {
            const aiVector3D& given = mesh.mTextureCoords[0][number];
            uv = glm::vec2(given.x, 1.0f - given.y) * options_.tiles;
        }
        mesh_.uv.push_back(uv);
        if (!isFinite(mesh_.positions.back()) || !isFinite(glm::vec3(uv, 0.0f)))
            reject(file_, fmt::format("vertex {} has a position or texture coordinates that are "
                                      "not finite, expected numbers",
                                      number + 1));
    }

    void addNormals(const aiMesh& mesh, const aiMatrix4x4& placement) {
        mesh_.normals.resize(mesh_.positions.size(), glm::vec3(0.0f));
        if (!mesh.HasNormals())
            return;
        aiMatrix3x3 linear(placement);
        linear.Inverse().Transpose();
        for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
            const glm::vec3 normal = turned(linear * mesh.mNormals[k]);
            if (isFinite(normal))
                mesh_.normals[mesh_.normals.size() - mesh.mNumVertices + k] = normal;
        }
    }

    const std::filesystem::path& file_;
    const aiScene& scene_;
    const MeshFileOptions& options_;
    TriangleMesh mesh_;
};

// In double precision, so that no size is too large or too small.
void bringToUnitSize(TriangleMesh& mesh) {
    glm::dvec3 low(mesh.positions.front());
    glm::dvec3 high = low;
    for (const std::uint32_t vertex : mesh.indices) {
        low = glm::min(low, glm::dvec3(mesh.positions[vertex]));
        high = glm::max(high, glm::dvec3(mesh.positions[vertex]));
    }
    const glm::dvec3 size = high - low;
    const double longest = std::max({size.x, size.y, size.z});
    if (longest == 0.0)
        return;
    for (glm::vec3& position : mesh.positions)
        position = glm::vec3((glm::dvec3(position) - 0.5 * (low + high)) / longest);
}

}  // namespace

SurfaceMesh readMeshFile(const std::filesystem::path& file, const MeshFileOptions& options) {
    Assimp::Importer importer;
    TriangleMesh triangles = MeshGatherer(file, import(importer, file), options).gather();
    if (triangles.indices.empty())
        reject(file, "has no faces, expected a mesh of triangles or polygons");
    if (options.toUnitSize)
        bringToUnitSize(triangles);
    SurfaceMesh mesh = withTangentFrames(triangles);
    if (mesh.indices.empty())
        reject(file, "all its faces are without an area, expected a surface");
    return mesh;
}

}  // namespace relievo::surfaces

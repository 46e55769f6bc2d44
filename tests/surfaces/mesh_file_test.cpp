// Meshes written by hand in several formats, and what is said of bad ones.
#include "surfaces/mesh_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/geometric.hpp>

#include "frame_checks.h"
#include "tests/textures/temporary_folder.h"

namespace relievo::surfaces {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using textures::errorOf;
using textures::writeBytes;

// A rectangle in the plane of x and y, 4 wide and 2 high, that faces +z; uv from its lower left.
constexpr const char* kObj = R"(v 1 1 0
v 5 1 0
v 5 3 0
v 1 3 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3 4/4
)";

std::string ply(const std::string& vertices, int vertexCount, const std::string& faces,
                int faceCount) {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty "
        "float z\nproperty float s\nproperty float t\nelement face {}\nproperty list uchar int "
        "vertex_indices\nend_header\n{}{}",
        vertexCount, faceCount, vertices, faces);
}

constexpr const char* kPlyVertices = "1 1 0 0 0\n5 1 0 1 0\n5 3 0 1 1\n1 3 0 0 1\n";

// The same rectangle as glTF has it, v downwards, of vertices from x = −1 to −5 that a node
// mirrors.
constexpr const char* kGltf = R"({
 "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0, "scale": [-1, 1, 1]}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}]}],
 "accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
   "min": [-5, 1, 0], "max": [-1, 3, 0]},
  {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
  {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
 "bufferViews": [
  {"buffer": 0, "byteOffset": 0, "byteLength": 48},
  {"buffer": 0, "byteOffset": 48, "byteLength": 32},
  {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
 "buffers": [{"byteLength": 92, "uri": "data:application/octet-stream;base64,AACAvwAAgD8AAAAAAACgwAAAgD8AAAAAAACgwAAAQEAAAAAAAACAvwAAQEAAAAAAAAAAAAAAgD8AAIA/AACAPwAAgD8AAAAAAAAAAAAAAAAAAAIAAQAAAAMAAgA="}]
})";

class MeshFile : public textures::TemporaryFolder {
  protected:
    std::filesystem::path written(const std::string& name, const std::string& text) const {
        writeBytes(file(name), text);
        return file(name);
    }
};

const SurfaceVertex& vertexAt(const SurfaceMesh& mesh, const glm::vec3& position) {
    for (const SurfaceVertex& vertex : mesh.vertices)
        if (glm::distance(vertex.position, position) < 1e-6f)
            return vertex;
    ADD_FAILURE() << "no vertex there";
    return mesh.vertices.front();
}

// Upright, facing −y, its upper left at the origin of (u,v).
void expectRectangle(const SurfaceMesh& mesh, Tiles tiles) {
    ASSERT_EQ(mesh.vertices.size(), 4u);
    ASSERT_EQ(mesh.indices.size(), 6u);
    EXPECT_TRUE(framesAgree(mesh));
    const SurfaceVertex& upperLeft = vertexAt(mesh, {-0.5f, 0, 0.25f});
    EXPECT_EQ(upperLeft.uv, glm::vec2(0, 0));
    EXPECT_EQ(upperLeft.normal, glm::vec3(0, -1, 0));
    EXPECT_LT(glm::distance(upperLeft.tangent, glm::vec3(1 / tiles.x, 0, 0)), 1e-6f);
    EXPECT_LT(glm::distance(upperLeft.bitangent, glm::vec3(0, 0, -0.5f / tiles.y)), 1e-6f);
    EXPECT_EQ(vertexAt(mesh, {0.5f, 0, -0.25f}).uv, tiles);
    EXPECT_EQ(mesh.windowMaximum, glm::vec2(kNoBorder));
}

TEST_F(MeshFile, FormatsAgree) {
    const MeshFileOptions options{.tiles = {4, 2}};
    expectRectangle(readMeshFile(written("a.obj", kObj), options), options.tiles);
    expectRectangle(readMeshFile(written("a.ply", ply(kPlyVertices, 4, "4 0 1 2 3\n", 1)), options),
                    options.tiles);
    expectRectangle(readMeshFile(written("a.gltf", kGltf), options), options.tiles);
}

TEST_F(MeshFile, SizesStayUnlessAskedOtherwise) {
    const SurfaceMesh mesh = readMeshFile(written("a.obj", kObj), {.toUnitSize = false});
    EXPECT_EQ(vertexAt(mesh, {1, 0, 3}).uv, glm::vec2(0, 0));
    EXPECT_TRUE(framesAgree(mesh));
}

TEST_F(MeshFile, AnySizeIsBroughtToUnity) {
    for (const char* exponent : {"e-30", "e30", "e37"}) {
        std::string obj;
        for (const char* corner : {"1 1", "5 1", "5 3", "1 3"})
            obj += fmt::format("v {0}{2} {1}{2} 0\n", corner[0], corner[2], exponent);
        obj += std::string(kObj).substr(std::string(kObj).find("vt"));
        expectRectangle(readMeshFile(written("a.obj", obj)), {1, 1});
    }
}

TEST_F(MeshFile, PointsAndLinesAreLeftOut) {
    const SurfaceMesh mesh = readMeshFile(written("a.obj", std::string(kObj) + "l 1 3\np 2\n"));
    EXPECT_EQ(mesh.indices.size(), 6u);
}

TEST_F(MeshFile, WithoutUvIsReadWhereNoneIsNeeded) {
    const auto plain = written("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(errorOf([&] { readMeshFile(plain); }),
                EndsWith("a.obj: has no texture coordinates, expected some to put a relief or a "
                         "shape on"));
    EXPECT_EQ(readMeshFile(plain, {.needsUv = false}).vertices.size(), 3u);
}

TEST_F(MeshFile, WhatIsWrongIsSaid) {
    const auto error = [&](const std::string& name, const std::string& text) {
        const auto mesh = written(name, text);
        return errorOf([&] { readMeshFile(mesh); });
    };
    EXPECT_THAT(errorOf([&] { readMeshFile(file("none.obj")); }),
                EndsWith("none.obj: no such file, expected a mesh"));
    EXPECT_THAT(errorOf([&] { readMeshFile(folder()); }), HasSubstr("no such file"));
    EXPECT_THAT(error("a.txt", kObj), EndsWith("no mesh format that is known, expected OBJ, PLY, "
                                               "glTF or another of assimp's"));
    EXPECT_THAT(error("a.ply", "no ply at all"), HasSubstr("a.ply: cannot be read as a mesh ("));
    EXPECT_THAT(error("a.gltf", "{"), HasSubstr("a.gltf: cannot be read as a mesh ("));
    EXPECT_THAT(error("empty.obj", ""), HasSubstr("empty.obj: "));
    EXPECT_THAT(error("points.ply", ply(kPlyVertices, 4, "", 0)), HasSubstr("points.ply: "));
    EXPECT_THAT(error("a.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n"),
                HasSubstr("not finite"));
    // Of an OBJ assimp takes these for 0 itself.
    EXPECT_THAT(error("uv.ply", ply("0 0 0 0 0\n1 0 0 inf 0\n0 1 0 0 1\n", 3, "3 0 1 2\n", 1)),
                HasSubstr("not finite"));
    EXPECT_THAT(error("a.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nvt 0 0\nf 1/1 2/1 3/1\n"),
                EndsWith("a.obj: all its faces are without an area, expected a surface"));
    EXPECT_THAT(error("a.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nvt 0 0\nf 1/1 2/1 3/1\n"),
                EndsWith("all its faces are without an area, expected a surface"));
}

// Meshes as people have them, where they are there.
TEST_F(MeshFile, RealMeshesHaveFramesEverywhere) {
    const char* const given = std::getenv("RELIEVO_SHARED_DATA");
    const std::filesystem::path data =
        given != nullptr ? given : RELIEVO_SOURCE_DIR "/../shared/data";
    const std::filesystem::path spot = data / "meshes" / "spot.obj";
    if (!std::filesystem::exists(spot))
        GTEST_SKIP() << "skipped: no file " << spot;
    const SurfaceMesh mesh = readMeshFile(spot);
    EXPECT_EQ(mesh.indices.size(), 3u * 5856u);
    std::size_t facing = 0;
    for (const SurfaceVertex& vertex : mesh.vertices) {
        EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-5f);
        EXPECT_GT(glm::length(vertex.tangent), 0.01f);
        EXPECT_GT(glm::length(vertex.bitangent), 0.01f);
        facing += glm::dot(glm::cross(vertex.bitangent, vertex.tangent), vertex.normal) > 0.0f;
    }
    EXPECT_GT(facing, 0u);
    fmt::print("{} vertices, {} of them with plain uv\n", mesh.vertices.size(), facing);
    EXPECT_THAT(errorOf([&] { readMeshFile(data / "meshes" / "bunny70k.ply"); }),
                HasSubstr("has no texture coordinates"));
    const SurfaceMesh bunny = readMeshFile(data / "meshes" / "bunny70k.ply", {.needsUv = false});
    EXPECT_NEAR(static_cast<double>(bunny.indices.size()), 3.0 * 69451, 300.0);
}

}  // namespace
}  // namespace relievo::surfaces

#pragma once

#include <filesystem>

#include "surfaces/surface_mesh.h"

namespace relievo::surfaces {

/// How a mesh file is read.
struct MeshFileOptions {
    Tiles tiles{1.0f};       ///< the file's uv are multiplied by them; > 0
    bool toUnitSize = true;  ///< centred at the origin, the longest side of its extent 1
    bool needsUv = true;     ///< a file without uv is refused; else its uv are 0
};

/// Reads the triangles and polygons of a file in any format of assimp's: OBJ, PLY, glTF and others;
/// all its meshes together, as its nodes place them. Such files have y up and v upwards: they are
/// turned to z up and to the top left origin. Tangent frames are those of withTangentFrames; its
/// normals are the file's where it has any. The window has no borders. Throws textures::InputError
/// for a file that cannot be read, has no triangle with an area, no uv where they are needed, or a
/// position or uv that is not finite.
SurfaceMesh readMeshFile(const std::filesystem::path& file, const MeshFileOptions& options = {});

}  // namespace relievo::surfaces

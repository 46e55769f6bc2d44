#include "viewer/carrier_mesh.h"

#include <cassert>

#include "surfaces/mesh_file.h"
#include "surfaces/parametric_meshes.h"

namespace relievo::viewer {

surfaces::SurfaceMesh makeCarrier(const ViewOptions& options, float aspect) {
    switch (options.object) {
        case ObjectKind::Quad:
            return surfaces::makeQuad(options.tiles, aspect);
        case ObjectKind::Box:
            return surfaces::makeBox(options.tiles);
        case ObjectKind::Sphere:
            return surfaces::makeSphere(options.tiles);
        case ObjectKind::Torus:
            return surfaces::makeTorus(options.tiles);
        case ObjectKind::File:
            return surfaces::readMeshFile(options.meshFile, {.tiles = options.tiles});
        case ObjectKind::ShapeBox:
            break;
    }
    assert(false);
    return {};
}

bool isWithoutBorders(ObjectKind object) {
    return object == ObjectKind::Sphere || object == ObjectKind::Torus ||
           object == ObjectKind::File;
}

glm::vec4 carrierWindow(const ViewOptions& options) {
    using surfaces::kNoBorder;
    return isWithoutBorders(options.object)
               ? glm::vec4(-kNoBorder, -kNoBorder, kNoBorder, kNoBorder)
               : glm::vec4(0.0f, 0.0f, options.tiles.x, options.tiles.y);
}

}  // namespace relievo::viewer

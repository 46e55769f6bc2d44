#include "viewer/box_placement.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

namespace relievo::viewer {
namespace {

// The directions of u, v and the depth in the box's own axes, as columns.
glm::dmat3 pictureAxes(BoxAxis along) {
    const glm::dvec3 x(1, 0, 0);
    const glm::dvec3 y(0, 1, 0);
    const glm::dvec3 z(0, 0, 1);
    switch (along) {
        case BoxAxis::X:
            return {y, -z, -x};
        case BoxAxis::Y:
            return {x, -z, y};
        case BoxAxis::Z:
            break;
    }
    return {x, -y, -z};
}

// Edges of the place along u, v and the depth.
glm::dvec3 pictureEdges(const PartPlace& place) {
    return glm::abs(glm::transpose(pictureAxes(place.along)) * (place.maximum - place.minimum));
}

}  // namespace

glm::dmat4 wholeToLocal(const glm::dvec3& size) {
    const glm::dvec3 flipped(size.x, -size.y, -size.z);
    return glm::translate(glm::scale(glm::dmat4(1.0), flipped), glm::dvec3(-0.5));
}

glm::dmat4 localToWorld(const glm::dvec3& position, const glm::dvec3& degrees) {
    const glm::dvec3 angles = glm::radians(degrees);
    glm::dmat4 placement = glm::translate(glm::dmat4(1.0), position);
    placement = glm::rotate(placement, angles.z, {0, 0, 1});
    placement = glm::rotate(placement, angles.y, {0, 1, 0});
    return glm::rotate(placement, angles.x, {1, 0, 0});
}

glm::dvec3 tileLengths(const PartPlace& place) {
    return pictureEdges(place) / place.tiles;
}

glm::dmat4 wholeToPart(const glm::dvec3& size, const PartPlace& place) {
    // From the box's own axes, around the centre of the place, to tiles from its corner.
    const glm::dmat4 tiles = glm::scale(glm::dmat4(1.0), 1.0 / tileLengths(place));
    const glm::dmat4 axes(glm::transpose(pictureAxes(place.along)));
    const glm::dmat4 centred =
        glm::translate(glm::dmat4(1.0), -0.5 * (place.minimum + place.maximum));
    return glm::translate(glm::dmat4(1.0), 0.5 * place.tiles) * tiles * axes * centred *
           wholeToLocal(size);
}

}  // namespace relievo::viewer

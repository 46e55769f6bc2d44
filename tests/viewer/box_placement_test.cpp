// Where boxes and their parts are, against coordinates written out.
#include "viewer/box_placement.h"

#include <gtest/gtest.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace relievo::viewer {
namespace {

glm::dvec3 moved(const glm::dmat4& map, const glm::dvec3& point) {
    return glm::dvec3(map * glm::dvec4(point, 1.0));
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(a[k], b[k], 1e-12) << "coordinate " << k;
}

TEST(BoxPlacement, FlipsVAndTheDepth) {
    const glm::dvec3 size(2.0, 3.0, 5.0);
    const glm::dmat4 map = wholeToLocal(size);
    expectNear(moved(map, {0.0, 0.0, 0.0}), {-1.0, 1.5, 2.5});
    expectNear(moved(map, {1.0, 1.0, 1.0}), {1.0, -1.5, -2.5});
    expectNear(moved(map, {0.75, 0.25, 0.1}), {0.5, 0.75, 2.0});
    EXPECT_GT(glm::determinant(map), 0.0) << "two flips make no mirror image";
}

TEST(BoxPlacement, TurnsAboutXThenYThenZ) {
    expectNear(moved(localToWorld({1, 2, 3}, {0, 0, 90}), {1, 0, 0}), {1, 3, 3});
    expectNear(moved(localToWorld({0, 0, 0}, {90, 0, 0}), {0, 1, 0}), {0, 0, 1});
    expectNear(moved(localToWorld({0, 0, 0}, {0, 90, 0}), {1, 0, 0}), {0, 0, -1});
    // y → z by x, stays by z; in the other order it would end on −x's side.
    expectNear(moved(localToWorld({0, 0, 0}, {90, 0, 90}), {0, 1, 0}), {0, 0, 1});
}

// Tile coordinates of points in the box's own axes.
struct Corner {
    BoxAxis along;
    glm::dvec3 origin;  // where (u,v,depth) = 0 is, of a place from −1 to 1
    glm::dvec3 u, v, depth;
};

class PartPlaces : public testing::TestWithParam<Corner> {};

TEST_P(PartPlaces, ShowTheirPictureToTheSideThatTheyFace) {
    const Corner& corner = GetParam();
    const glm::dvec3 size(4.0, 6.0, 8.0);
    PartPlace place{glm::dvec3(-1.0), glm::dvec3(1.0), corner.along, {3.0, 2.0, 5.0}};
    const glm::dmat4 fromLocal = wholeToPart(size, place) * glm::inverse(wholeToLocal(size));
    expectNear(moved(fromLocal, corner.origin), {0, 0, 0});
    expectNear(moved(fromLocal, corner.origin + 2.0 * corner.u), {3, 0, 0});
    expectNear(moved(fromLocal, corner.origin + 2.0 * corner.v), {0, 2, 0});
    expectNear(moved(fromLocal, corner.origin + 2.0 * corner.depth), {0, 0, 5});
    // Letters are not mirrored: seen along the depth, v is to the right of u.
    expectNear(glm::cross(corner.u, corner.v), corner.depth);
    EXPECT_GT(glm::determinant(fromLocal), 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Axes, PartPlaces,
    testing::Values(Corner{BoxAxis::Z, {-1, 1, 1}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                    Corner{BoxAxis::Y, {-1, -1, 1}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                    Corner{BoxAxis::X, {1, -1, 1}, {0, 1, 0}, {0, 0, -1}, {-1, 0, 0}}));

TEST(BoxPlacement, APartThatFillsItsBoxHasItsTileSpace) {
    const glm::dvec3 size(4.0, 6.0, 8.0);
    const PartPlace place{-0.5 * size, 0.5 * size, BoxAxis::Z, glm::dvec3(1.0)};
    const glm::dvec3 point(0.2, 0.7, 0.9);
    expectNear(moved(wholeToPart(size, place), point), point);
}

TEST(BoxPlacement, TilesAreAsLongAsTheirShareOfThePlace) {
    const PartPlace place{{-1, -2, -3}, {1, 2, 3}, BoxAxis::X, {4, 3, 1}};
    expectNear(tileLengths(place), {1.0, 2.0, 2.0});  // y, z and x
}

}  // namespace
}  // namespace relievo::viewer

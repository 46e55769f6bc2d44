// The scenes in scenes/: that they can be read, that their shapes keep their proportions, and that
// their documented numbers of triangles are what is counted.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/textures/temporary_folder.h"
#include "viewer/scene_file.h"
#include "viewer/tessellation_count.h"

namespace relievo::viewer {
namespace {

const std::filesystem::path kSources = RELIEVO_SOURCE_FOLDER;

class BundledScenes : public testing::TestWithParam<std::string> {
  protected:
    [[nodiscard]] static SceneFile read() {
        return readSceneFile(kSources / "scenes" / (GetParam() + ".json"));
    }
};

bool hasOffsets(const solids::Solid& solid) {
    return std::ranges::any_of(solid.profile.pieces, [](const solids::ProfilePiece& piece) {
        return piece.topOffset != 0.0 || piece.bottomOffset != 0.0;
    });
}

// How much longer one direction of the drawing is than another: 1 for a part that shows its drawing
// as it is. Only where it shows: a solid without offsets may be stretched at will.
double distortion(const ScenePart& part, double aspect) {
    const glm::dvec3 tile = tileLengths(part.place);
    std::vector<double> widths = {tile.x};
    if (part.part.solid.kind == solids::SolidKind::Revolution)
        widths.insert(widths.end(), {tile.y, tile.z / aspect});
    else if (hasOffsets(part.part.solid))
        widths.push_back(tile.y / aspect);
    return *std::max_element(widths.begin(), widths.end()) /
           *std::min_element(widths.begin(), widths.end());
}

double aspectOf(const SceneFile& scene, const ScenePart& part) {
    return readShapeDrawing(scene.shapes.at(part.shape), 1e-3).aspect;
}

TEST_P(BundledScenes, HaveShapesThatAreUsedAndFillSomething) {
    const SceneFile scene = read();
    std::set<std::string> used;
    for (const SceneBox& box : scene.boxes)
        for (const ScenePart& part : box.parts)
            used.insert(part.shape);
    for (const auto& [name, shape] : scene.shapes) {
        EXPECT_TRUE(used.contains(name)) << name;
        const outlines::Drawing drawing = readShapeDrawing(shape, 1e-3);
        const ShapeBoundary boundary = boundaryOf(drawing, glm::dvec2(1.0), shape.wrap);
        EXPECT_GE(boundary.pieces(), 1u) << name;
        EXPECT_GE(boundary.vertices, 3u) << name;
    }
}

TEST_P(BundledScenes, ShowDrawingsWithoutDistortion) {
    const SceneFile scene = read();
    for (const SceneBox& box : scene.boxes)
        for (const ScenePart& part : box.parts)
            EXPECT_LT(distortion(part, aspectOf(scene, part)), 1.01)
                << box.name << " " << part.shape;
    // A part that is a tenth too high is seen.
    ScenePart high = scene.boxes[0].parts[0];
    high.part.solid.kind = solids::SolidKind::Revolution;
    high.place.maximum += 0.1 * (high.place.maximum - high.place.minimum) * glm::dvec3(0, 0, 1);
    EXPECT_GT(distortion(high, aspectOf(scene, high)), 1.01);
}

// A revolved section that reaches further than the nearest side of its tile would be cut by it.
TEST_P(BundledScenes, HaveSectionsWithinTheirTiles) {
    const SceneFile scene = read();
    for (const SceneBox& box : scene.boxes)
        for (const ScenePart& part : box.parts) {
            if (part.part.solid.kind != solids::SolidKind::Revolution)
                continue;
            const glm::dvec2 axis = part.part.solid.axis;
            const double room = std::min({axis.x, axis.y, 1.0 - axis.x, 1.0 - axis.y});
            const outlines::Drawing drawing = readShapeDrawing(scene.shapes.at(part.shape), 1e-4);
            for (const outlines::Contour& contour :
                 boundaryOf(drawing, glm::dvec2(1.0), textures::WrapMode::Clamp).contours)
                for (const glm::dvec2& point : contour)
                    EXPECT_LT(point.x + part.part.solid.extension, room) << part.shape;
        }
}

// Whether a cap of `cut` lies in one of `part`, inside of the box.
bool sharesACap(const SceneBox& box, const ScenePart& part, const ScenePart& cut) {
    if (part.part.solid.kind != solids::SolidKind::Extrusion || part.place.along != cut.place.along)
        return false;
    const int depth = static_cast<int>(cut.place.along);
    const auto isShared = [&](double a, double b) {
        return a == b && std::abs(a) < 0.5 * box.size[depth];
    };
    return isShared(part.place.minimum[depth], cut.place.minimum[depth]) ||
           isShared(part.place.maximum[depth], cut.place.maximum[depth]);
}

// With caps in one plane it would be up to rounding what is seen.
TEST_P(BundledScenes, CutBeyondWhatTheyCut) {
    for (const SceneBox& box : read().boxes)
        for (const ScenePart& cut : box.parts)
            for (const ScenePart& part : box.parts)
                if (cut.part.operation == solids::BooleanOperation::Difference && &part != &cut) {
                    EXPECT_FALSE(sharesACap(box, part, cut)) << part.shape << " " << cut.shape;
                }
}

TEST_P(BundledScenes, TakeTheTrianglesThatTheDocumentSays) {
    const SceneTriangles count = countTriangles(read());
    EXPECT_EQ(count.uncounted, 0u);
    EXPECT_GT(count.tessellated, 50 * count.drawn);
    EXPECT_THAT(textures::readBytes(kSources / "docs/scenes.md"),
                testing::HasSubstr(fmt::format("| `{}.json` | {} | {} | {} |", GetParam(),
                                               count.boxes, count.drawn, count.tessellated)));
}

INSTANTIATE_TEST_SUITE_P(Scenes, BundledScenes,
                         testing::Values("chess", "frieze", "temple", "arcade"),
                         [](const auto& scene) { return scene.param; });

TEST(SceneDocument, HasAnExampleThatCanBeRead) {
    const std::string document = textures::readBytes(kSources / "docs/scenes.md");
    const std::size_t begin = document.find("```json\n") + 8;
    ASSERT_NE(begin, std::string::npos + 8);
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("relievo-scene-{}.json", ::getpid());
    textures::writeBytes(file, document.substr(begin, document.find("```", begin) - begin));
    const SceneFile scene = readSceneFile(file);
    std::filesystem::remove(file);
    ASSERT_EQ(scene.boxes.size(), 2u);
    EXPECT_EQ(scene.boxes[1].wholeToWorld.size(), 3u);
}

TEST(BundledScenesFolder, HasNoOtherScenesAndNoShapeThatNoneUses) {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kSources / "scenes"))
        if (entry.is_regular_file())
            files.insert(entry.path());
    for (const std::string name : {"chess", "frieze", "temple", "arcade"}) {
        const std::filesystem::path file = kSources / "scenes" / (name + ".json");
        files.erase(file);
        for (const auto& [shapeName, shape] : readSceneFile(file).shapes)
            files.erase(shape.file);
    }
    EXPECT_EQ(files, std::set<std::filesystem::path>());
}

}  // namespace
}  // namespace relievo::viewer

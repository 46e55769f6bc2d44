// Shape maps as map sets and files, and what is refused.
#include "textures/shape_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_planes.h"
#include "temporary_folder.h"
#include "textures/input_error.h"
#include "textures/map_file.h"

namespace relievo::textures {
namespace {

ShapeMap randomShape(bool isSigned) {
    return {randomPlane(23, 17, isSigned ? -0.2f : 0.0f, 0.4f, 1),
            randomPlane(23, 17, -1.0f, 1.0f, 2),
            randomPlane(23, 17, -1.0f, 1.0f, 3),
            randomPlane(23, 17, 0.0f, 1.0f, 4),
            WrapMode::Mirror,
            isSigned,
            0.0123};
}

// Codes of both kinds, convex ones near the outline, and steps as high as they may be.
ShapeMap creasedShape() {
    ShapeMap shape = randomShape(true);
    shape.creases = {randomPlane(23, 17, -1.0f, 1.0f, 5), Plane(23, 17)};
    for (std::size_t t = 0; t < shape.creases.step.texels.size(); ++t) {
        if (!shape.isReflex(t))
            shape.distance.texels[t] = std::min(shape.distance.texels[t], 2.5f / 23.0f);
        shape.creases.step.texels[t] = mostStep(shape, t);
    }
    return shape;
}

class ShapeMapFile : public TemporaryFolder {};

TEST_F(ShapeMapFile, ComesBackInEveryFormat) {
    for (const bool isSigned : {true, false})
        for (const auto& [name, format] : {std::pair{"a.exr", StorageFormat::Float},
                                           {"b.exr", StorageFormat::Half},
                                           {"c.png", StorageFormat::U16},
                                           {"d.tif", StorageFormat::U16},
                                           {"e.png", StorageFormat::U8},
                                           {"f.tif", StorageFormat::U8}}) {
            const ShapeMap shape = randomShape(isSigned);
            writeMapFile(file(name), mapSetOf(shape), format);
            const ShapeMap again = shapeMapOf(readMapFile(file(name)));
            EXPECT_EQ(again.distance.texels,
                      storedValues(shape.distance, "distance", format).texels)
                << name;
            EXPECT_EQ(again.gradientX.texels, storedValues(shape.gradientX, "gx", format).texels);
            EXPECT_EQ(again.gradientY.texels, storedValues(shape.gradientY, "gy", format).texels);
            EXPECT_EQ(again.shape.texels, storedValues(shape.shape, "shape", format).texels);
            EXPECT_EQ(again.wrap, WrapMode::Mirror);
            EXPECT_EQ(again.isSigned, isSigned);
            EXPECT_EQ(again.slack, shape.slack);
        }
}

TEST_F(ShapeMapFile, CreasesComeBackInExr) {
    const ShapeMap shape = creasedShape();
    writeMapFile(file("a.exr"), mapSetOf(shape), StorageFormat::Float);
    const ShapeMap again = shapeMapOf(readMapFile(file("a.exr")));
    EXPECT_EQ(again.creases.code.texels, shape.creases.code.texels);
    EXPECT_EQ(again.creases.step.texels, shape.creases.step.texels);
    EXPECT_EQ(creaseDepth(again), creaseDepth(shape));
    EXPECT_FALSE(shapeMapOf(mapSetOf(randomShape(true))).isCreased());
}

// From three quarters of R on a crease is a reflex one, above which the distance is not lowered.
TEST(ShapeMap, StepsKeepToWhatCreasesAllow) {
    ShapeMap shape = creasedShape();
    shape.distance.texels[7] = 0.05f;
    for (const float sign : {1.0f, -1.0f}) {
        shape.creases.code.texels[7] = sign * 2.0f / 23.0f;
        EXPECT_FLOAT_EQ(mostStep(shape, 7), 0.05f - 1.0f / 23.0f);
        shape.creases.code.texels[7] = sign * 12.5f / 23.0f;
        EXPECT_EQ(mostStep(shape, 7), 0.05f);
    }
    shape.creases.step.texels[7] = 0.05f;
    EXPECT_NO_THROW(shapeMapOf(mapSetOf(shape)));
    shape.creases.step.texels[7] = 0.0501f;
    EXPECT_THROW(shapeMapOf(mapSetOf(shape)), InputError);
}

// Only corners of the outline itself: steps go by distances from some offset on.
TEST(ShapeMap, RefusesConvexCreasesFarFromTheOutline) {
    ShapeMap shape = creasedShape();
    const auto most = static_cast<float>((kCornersEndTexels - std::sqrt(2.0)) / shape.width());
    shape.creases.step.texels[7] = -1.0f;
    for (const float code : {2.0f, -2.0f, 12.5f}) {
        shape.creases.code.texels[7] = code / static_cast<float>(shape.width());
        shape.distance.texels[7] = 0.999f * most;
        EXPECT_NO_THROW(shapeMapOf(mapSetOf(shape)));
        shape.distance.texels[7] = 1.001f * most;
        if (code > 12.0f)
            EXPECT_NO_THROW(shapeMapOf(mapSetOf(shape)));
        else
            EXPECT_THROW(shapeMapOf(mapSetOf(shape)), InputError);
    }
}

TEST(ShapeMap, RefusesWhatMakesNoShape) {
    const MapSet good = mapSetOf(randomShape(true));
    EXPECT_NO_THROW(shapeMapOf(good));
    for (std::size_t c = 0; c < good.channels.size(); ++c) {
        MapSet maps = good;
        maps.channels.erase(maps.channels.begin() + static_cast<std::ptrdiff_t>(c));
        EXPECT_THROW(shapeMapOf(maps), InputError) << good.channels[c].name;
    }
    for (const auto& [name, text] : {std::pair{"relievo:signed", "yes"},
                                     {"relievo:slack", "-1"},
                                     {"relievo:slack", "nan"},
                                     {"relievo:slack", "0.1 m"}}) {
        MapSet maps = good;
        maps.attributes[name] = text;
        EXPECT_THROW(shapeMapOf(maps), InputError) << name << " " << text;
    }
    MapSet relief = good;
    relief.kind = "relief";
    EXPECT_THROW(shapeMapOf(relief), InputError);
    for (const std::size_t c : {4u, 5u}) {
        MapSet creased = mapSetOf(creasedShape());
        creased.channels[c].plane.texels[3] = HUGE_VALF;
        EXPECT_THROW(shapeMapOf(creased), InputError) << creased.channels[c].name;
    }
    MapSet half = mapSetOf(creasedShape());
    half.channels.pop_back();
    EXPECT_THROW(shapeMapOf(half), InputError);
    MapSet endless = good;
    endless.channels[2].plane.texels[3] = HUGE_VALF;
    EXPECT_THROW(shapeMapOf(endless), InputError);
}

}  // namespace
}  // namespace relievo::textures

// Reliefs and solids on curved surfaces: each pixel shows what the exact rays find from the surface
// that carries it, as on a quad; pictures have no holes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "float_rounding.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "surfaces/parametric_meshes.h"
#include "surfaces/tangent_frames.h"
#include "viewer/carrier_mesh.h"
#include "viewer/scene_errors.h"
#include "viewer/solid_session.h"
#include "viewer/view_session.h"

namespace relievo::viewer {
namespace {

constexpr int kSize = 160;
constexpr int kWorldSize = 80;  // every ray is tried on every triangle

// A torus whose uv lean to one side and are mirrored, with the frames that follow from them.
// FloatRounding knows of uv from 0 on.
surfaces::SurfaceMesh skewedTorus() {
    const surfaces::SurfaceMesh torus = surfaces::makeTorus({8, 4});
    surfaces::TriangleMesh triangles;
    for (const surfaces::SurfaceVertex& vertex : torus.vertices) {
        triangles.positions.push_back(vertex.position);
        triangles.uv.push_back({vertex.uv.x + vertex.uv.y, 4.0f - vertex.uv.y});
    }
    triangles.indices = torus.indices;
    return surfaces::withTangentFrames(triangles);
}

struct CurvedSurface {
    std::string_view name;
    std::function<surfaces::SurfaceMesh()> make;
};

const CurvedSurface kSurfaces[] = {{"sphere",
                                    [] {
                                        return surfaces::makeSphere({8, 4});
                                    }},
                                   {"torus",
                                    [] {
                                        return surfaces::makeTorus({8, 4});
                                    }},
                                   {"skewed_torus", skewedTorus}};

class CurvedSurfaces : public testing::TestWithParam<const CurvedSurface*> {
  protected:
    CurvedSurfaces()
        : map_(textures::generateSampleRelief("bricks", 64, 64)),
          maps_(bakeMaps(map_)),
          mesh_(GetParam()->make()) {}

    static Camera lookFrom(float azimuth, float elevation) {
        OrbitCamera orbit;
        orbit.azimuth = azimuth;
        orbit.elevation = elevation;
        return perspectiveCamera(orbit, 1.0f);
    }

    // The frame of the mesh with the relief, against the exact one of `exact`.
    SceneErrors errorsAgainst(const ExactObject& exact, const Camera& camera) {
        const SurfaceBuffers buffers(mesh_);
        materials::ReliefMaterial material(std::make_shared<materials::ReliefMaps>(maps_, "test"),
                                           materials::findTechnique("exact"));
        material.depthScale = kDepthScale;
        SceneObject object;
        object.surface = &buffers;
        object.material = &material;
        FrameView view;
        view.camera = camera;
        return compareScene(frames_.show({&object, 1}, view, kWorldSize, kWorldSize),
                            traceScene({&exact, 1}, camera, kWorldSize, kWorldSize), camera);
    }
    ExactObject exactObject() const {
        return {&mesh_, &map_, kDepthScale,
                glm::dvec4(-kInfinity, -kInfinity, kInfinity, kInfinity)};
    }

    static constexpr float kDepthScale = 0.15f;
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::unique_ptr<gl::Context> context_ = makeTestContext();
    textures::DepthMap map_;
    textures::MapSet maps_;
    surfaces::SurfaceMesh mesh_;
    FrameRenderer frames_;
};

TEST_P(CurvedSurfaces, FirstHitsAreThoseOfTheTracer) {
    const FloatRounding rounding(map_);
    RayScene scene(maps_, 0.0f, 90.0f, kDepthScale);
    scene.renderer.setSurface(mesh_);
    materials::ReliefMaterial material =
        scene.renderer.makeMaterial(materials::findTechnique("exact"));
    std::size_t rays = 0;
    std::size_t hits = 0;
    std::size_t wrong = 0;
    for (const float elevation : {90.0f, 35.0f, 0.0f, -60.0f}) {
        scene.view.camera = lookFrom(25.0f, elevation);
        for (const MeasuredPixel& pixel :
             scene.renderer.measure(material, scene.view, kSize, kSize).pixels) {
            rays += pixel.covered;
            hits += pixel.covered && pixel.outcome == RELIEVO_OUTCOME_HIT;
            wrong += pixel.covered && !rounding.explains(pixel);
        }
    }
    fmt::print("{}: {} rays, {} hits, {} wrong\n", GetParam()->name, rays, hits, wrong);
    EXPECT_GT(rays, 20000u);
    EXPECT_GT(hits, rays * 99 / 100);
    EXPECT_EQ(wrong, 0u);
}

// The same in world space, from the triangles themselves: frames, rays and depths.
TEST_P(CurvedSurfaces, PixelsShowThePointsOfTheReliefInTheWorld) {
    for (const float elevation : {40.0f, -20.0f}) {
        const Camera camera = lookFrom(25.0f, elevation);
        const SceneErrors errors = errorsAgainst(exactObject(), camera);
        fmt::print(
            "{} from {}°: {} pixels, another object {:.4f} %, wrong {:.4f} %, mean shift "
            "{:.2g} pixels\n",
            GetParam()->name, elevation, errors.pixels, 100 * errors.wrongObjectShare,
            100 * errors.wrongShare, errors.meanShift);
        EXPECT_GT(errors.pixels, 1500u);
        EXPECT_LE(errors.wrongShare, 4e-4);
        EXPECT_LE(errors.meanShift, 1e-3);
    }
    ExactObject deeper = exactObject();
    deeper.depthScale *= 1.1;
    EXPECT_GT(errorsAgainst(deeper, lookFrom(25.0f, 40.0f)).meanShift, 0.02);
}

std::vector<const CurvedSurface*> everySurface() {
    std::vector<const CurvedSurface*> surfaces;
    for (const CurvedSurface& surface : kSurfaces)
        surfaces.push_back(&surface);
    return surfaces;
}

INSTANTIATE_TEST_SUITE_P(Meshes, CurvedSurfaces, testing::ValuesIn(everySurface()),
                         nameOfTest<CurvedSurface>);

class CurvedPictures : public testing::TestWithParam<ObjectKind> {
  protected:
    static ViewOptions optionsFor(ObjectKind object) {
        ViewOptions options;
        options.object = object;
        options.tiles = {8, 4};
        options.solid.bevel = 0.05;
        options.solid.chamfer = 0.4;
        return options;
    }
    struct Content {
        std::size_t shown = 0;  ///< pixels that are not background
        std::size_t edges = 0;  ///< where the brightness jumps within the object
    };
    static Content contentOf(const gl::Framebuffer& target) {
        const std::vector<float> rgba = target.read(0);
        const auto isShown = [&](std::size_t k) { return rgba[4 * k] > 0.15f; };
        Content content;
        for (std::size_t k = 0; k + 1 < rgba.size() / 4; ++k) {
            content.shown += isShown(k);
            content.edges +=
                isShown(k) && isShown(k + 1) && std::abs(rgba[4 * k] - rgba[4 * k + 4]) > 0.05f;
        }
        return content;
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    gl::Framebuffer target_ = makeColorTarget(kSize, kSize);
};

TEST_P(CurvedPictures, ShowAReliefAndAShape) {
    ViewOptions options = optionsFor(GetParam());
    SceneRenderer renderer(bakeMaps(textures::generateSampleRelief("bricks", 64, 64)), "test", {});
    renderer.setSurface(makeCarrier(options, 1.0f));
    materials::ReliefMaterial material = renderer.makeMaterial(materials::findTechnique("exact"));
    const View view = makeView(options, 1.0f);
    EXPECT_EQ(view.window, carrierWindow(options));
    renderer.draw(material, view, target_);
    const Content relief = contentOf(target_);
    EXPECT_GT(relief.shown, 4000u);
    EXPECT_GT(relief.edges, 400u);

    options.files = {RELIEVO_SOURCE_FOLDER "/scenes/shapes/star.svg"};
    SolidSession session(options, materials::findSolidTechnique("solid"));
    session.draw(options, target_);
    const Content shape = contentOf(target_);
    EXPECT_GT(shape.shown, 4000u);
    EXPECT_GT(shape.edges, 200u);
    // Without depth nothing but the surface is left.
    options.depthScale = 0.0f;
    session.edit(options);
    session.draw(options, target_);
    EXPECT_LT(contentOf(target_).edges, shape.edges / 2);
}

INSTANTIATE_TEST_SUITE_P(Objects, CurvedPictures,
                         testing::Values(ObjectKind::Sphere, ObjectKind::Torus));

// A ray straight to where all tiles end in one point.
TEST(SpherePole, IsThere) {
    const std::unique_ptr<gl::Context> context = makeTestContext();
    ViewOptions options;
    options.object = ObjectKind::Sphere;
    options.tiles = {8, 4};
    options.camera.elevation = 90.0f;
    options.files = {RELIEVO_SOURCE_FOLDER "/scenes/shapes/star.svg"};
    SolidSession session(options, materials::findSolidTechnique("solid"));
    constexpr int kOddSize = 33;
    const MeasuredFrame frame = session.measure(options, kOddSize, kOddSize);
    const MeasuredPixel& middle = frame.pixels[kOddSize * kOddSize / 2];
    EXPECT_TRUE(middle.covered);
    EXPECT_EQ(middle.outcome, RELIEVO_OUTCOME_HIT);
}

}  // namespace
}  // namespace relievo::viewer

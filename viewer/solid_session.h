#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/frame_renderer.h"
#include "viewer/solid_errors.h"
#include "viewer/solid_stage.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// Where a solid of one shape is and how far it goes.
struct SolidPlace {
    ObjectKind object = ObjectKind::Quad;
    glm::dvec3 tiles{1.0};    ///< in u, v and z
    glm::dvec3 boxSize{0.0};  ///< edges of a shape box; 0 of another object
    double tileAspect = 1.0;  ///< height of a tile on a quad over its width

    friend bool operator==(const SolidPlace&, const SolidPlace&) = default;
};

/// The place that the options give to a solid of `shape`. Throws textures::InputError for a shape
/// box without a depth.
SolidPlace placeOf(const ViewOptions& options, const textures::ShapeMap& shape);

/// How far a picture is that is drawn object by object.
struct SolidProgress {
    bool isOfShadows = false;  ///< the shadow map is drawn, not yet the picture
    std::size_t done = 0;      ///< objects that are in it
    std::size_t count = 0;     ///< of all
};

/// A scene file or a single shape that relievo-view shows, by one search.
class SolidSession {
  public:
    /// Opens options.files.front(). Needs a current context. Throws textures::InputError.
    SolidSession(const ViewOptions& options, const materials::SolidTechnique& technique);

    /// Follows the options: a shape is what they say from the next picture on, with its object, its
    /// box and its tiles. Of a scene only the parameters of the search change. Throws
    /// textures::InputError, after which another edit may succeed.
    void edit(const ViewOptions& options);
    /// Draws into attachment 0 of `target`, with the shadows of a light far away.
    void draw(const ViewOptions& options, gl::Framebuffer& target);
    /// The same object by object: begin(), and then step() until it returns that nothing is left to
    /// draw. The context may be used for other things in between. An edit ends it. A shadow map
    /// that is begun goes on with the next picture of the same light.
    void begin(const ViewOptions& options, gl::Framebuffer& target);
    bool step();
    [[nodiscard]] SolidProgress progress() const;
    /// Draws all at once, with the shadows that are there already.
    void draft(const ViewOptions& options, gl::Framebuffer& target);
    /// Copies what is drawn into `shown`, which has the size and the format of the target. For what
    /// is missing stand the boxes, or other surfaces, that the solids are in: they need no program
    /// of a search.
    void showUnfinished(const gl::Framebuffer& shown);
    /// Steps and lookups of the searches of a frame of that size; of a shape alone.
    MeasuredFrame measure(const ViewOptions& options, int width, int height);
    /// How far such a frame is from the exact hits of its rays.
    [[nodiscard]] SolidErrors errorsOf(const MeasuredFrame& frame,
                                       const ViewOptions& options) const;

    /// The scene, or nothing for a shape.
    [[nodiscard]] const std::optional<SceneFile>& scene() const noexcept { return scene_; }
    /// The shape; null for a scene.
    [[nodiscard]] const textures::ShapeMap* shape() const noexcept { return shape_.get(); }
    [[nodiscard]] SolidStage& stage() noexcept { return *stage_; }

    [[nodiscard]] const materials::SolidTechnique& technique() const noexcept {
        return *technique_;
    }

  private:
    void followShape(const ViewOptions& options);
    void stageShape(const ViewOptions& options, const SolidPlace& place);
    void setParameters(const std::vector<ParameterSetting>& settings);
    std::shared_ptr<const textures::ShapeMap> shapeFor(const ViewOptions& options);
    const ShadowMap* shadowsFor(const ViewOptions& options);
    [[nodiscard]] FrameView viewOf(const ViewOptions& options, float aspect) const;
    [[nodiscard]] FrameView viewOf(const ViewOptions& options, const gl::Framebuffer& target) const;

    struct Shadows {
        glm::vec2 light;
        ShadowMap map;
        std::size_t casters = 0;  // the first of the objects, which are in it
    };
    struct Steps {
        gl::Framebuffer* target;
        std::vector<SceneObject> objects;
        FrameView view;
        std::size_t drawn = 0;
    };

    const materials::SolidTechnique* technique_;
    std::optional<SceneFile> scene_;
    // Of a shape: the map of each wrap mode that has been shown, and the one that is.
    std::map<textures::WrapMode, std::shared_ptr<const textures::ShapeMap>> shapes_;
    std::shared_ptr<const textures::ShapeMap> shape_;
    SolidPlace place_;
    materials::SolidMaterial* material_ = nullptr;  // of the shape
    std::unique_ptr<SolidStage> stage_;
    FrameRenderer frames_;
    // Of a scene, while neither the light nor the search changes.
    std::optional<Shadows> shadows_;
    std::optional<Steps> steps_;
    std::vector<ParameterSetting> parameters_;
};

/// Whether the name is that of a scene file.
bool isSceneFile(const std::string& file);

/// How a drawing goes on around its tile when it is shown with these options: an extrusion in
/// several tiles is repeated.
textures::WrapMode wrapModeFor(const ViewOptions& options);

/// The camera and the light of a scene, for options whose command line has none.
void takeSceneView(const SceneFile& scene, ViewOptions& options);

}  // namespace relievo::viewer

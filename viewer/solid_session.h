#pragma once

#include <memory>
#include <optional>
#include <string>

#include "viewer/frame_renderer.h"
#include "viewer/solid_stage.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// A scene file or a single shape that relievo-view shows, by one search.
class SolidSession {
  public:
    /// Opens options.files.front(). Needs a current context. Throws textures::InputError.
    SolidSession(const ViewOptions& options, const materials::SolidTechnique& technique);

    /// Follows the options for shapes, the depth scale and the tiles: a shape looks as they say
    /// from the next picture on. Of a scene nothing changes.
    void edit(const ViewOptions& options);
    /// Draws into attachment 0 of `target`, with the shadows of a light far away.
    void draw(const ViewOptions& options, gl::Framebuffer& target);
    /// Steps and lookups of the searches of a frame of that size; of a shape alone.
    MeasuredFrame measure(const ViewOptions& options, int width, int height);

    /// The scene, or nothing for a shape.
    [[nodiscard]] const std::optional<SceneFile>& scene() const noexcept { return scene_; }
    /// The shape; null for a scene.
    [[nodiscard]] const textures::ShapeMap* shape() const noexcept { return shape_.get(); }
    [[nodiscard]] SolidStage& stage() noexcept { return *stage_; }

  private:
    void openScene(const std::string& file);
    void openShape(const ViewOptions& options);
    void openWallRelief(const ViewOptions& options);
    [[nodiscard]] FrameView viewOf(const ViewOptions& options, float aspect) const;

    std::optional<SceneFile> scene_;
    std::shared_ptr<const textures::ShapeMap> shape_;
    std::unique_ptr<SolidStage> stage_;
    materials::SolidMaterial* material_ = nullptr;  // of the shape
    FrameRenderer frames_;
};

/// Whether the name is that of a scene file.
bool isSceneFile(const std::string& file);

/// The camera and the light of a scene, for options whose command line has none.
void takeSceneView(const SceneFile& scene, ViewOptions& options);

}  // namespace relievo::viewer

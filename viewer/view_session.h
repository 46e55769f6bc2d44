#pragma once

#include <memory>
#include <vector>

#include "viewer/scene_renderer.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// Reads the map file and the texture set and puts the relief on the object that `options` name.
/// Needs a current context. Throws textures::InputError.
std::unique_ptr<SceneRenderer> openRelief(const std::filesystem::path& file,
                                          const ViewOptions& options);

/// The view of `options` in a frame of the given width/height.
View makeView(const ViewOptions& options, float frameAspect);

/// A material for `technique` with the values of `options.parameters` that concern it. Throws
/// textures::InputError for a value out of range or a missing channel.
materials::ReliefMaterial makeConfiguredMaterial(const SceneRenderer& renderer,
                                                 const materials::Technique& technique,
                                                 const ViewOptions& options);

}  // namespace relievo::viewer

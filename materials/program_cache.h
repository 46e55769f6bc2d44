#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/program.h"
#include "shaders/shader_library.h"

namespace relievo::materials {

/// Builds the programs of a renderer that uses the library's own vertex and fragment shaders, each
/// combination once. A program contains the one technique it was asked for and the features whose
/// defines were given, nothing else.
class ProgramCache {
  public:
    /// The program of relievo/programs/surface.vert and `fragmentFile` after the files of a
    /// material (ReliefMaterial::files; none for a mesh without one), all paths of the shader
    /// library. The reference stays valid as long as the cache. Throws gl::GlError when the driver
    /// refuses the text.
    gl::Program& get(std::string_view fragmentFile,
                     const std::vector<std::string_view>& materialFiles,
                     std::span<const shaders::Define> defines);

    [[nodiscard]] std::size_t size() const noexcept { return programs_.size(); }

  private:
    std::map<std::string, gl::Program> programs_;
};

/// The fragment shader text that `ProgramCache` compiles, for tools that check or export it.
shaders::ExpandedShader expandFragment(std::string_view fragmentFile,
                                       const std::vector<std::string_view>& materialFiles,
                                       std::span<const shaders::Define> defines);

}  // namespace relievo::materials

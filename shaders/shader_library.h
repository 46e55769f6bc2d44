#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::shaders {

/// A file of the GLSL library, embedded in the program. Paths are those of #include lines, such as
/// "relievo/techniques/cone.glsl".
struct LibraryFile {
    std::string_view path;
    std::string_view text;
};

/// All embedded files, sorted by path.
std::span<const LibraryFile> libraryFiles();

/// The text of one embedded file; nothing when there is none of that path.
std::optional<std::string_view> libraryText(std::string_view path);

/// `#define name value`.
struct Define {
    std::string name;
    std::string value;
};

/// An include that cannot be resolved; the message names file, line and path.
class IncludeError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A shader text without includes. `#line N K` lines in it refer to files[K], for error messages.
struct ExpandedShader {
    std::string text;
    std::vector<std::string> files;
};

/// Expands the `#include "path"` lines of `text` from the library, each file once. `name` stands
/// for `text` itself in messages. `header` (such as "#version 450 core") comes first, then the
/// defines. Throws IncludeError.
ExpandedShader expandShader(std::string_view name, std::string_view text, std::string_view header,
                            std::span<const Define> defines = {});

}  // namespace relievo::shaders

#include "shaders/shader_library.h"

#include <fmt/format.h>

#include <algorithm>

namespace relievo::shaders {
namespace {

// The path of `#include "path"`, or nothing for any other line.
std::optional<std::string_view> includedPath(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos || !line.substr(start).starts_with("#include"))
        return std::nullopt;
    const std::size_t open = line.find('"', start);
    const std::size_t close = open == std::string_view::npos ? open : line.find('"', open + 1);
    if (close == std::string_view::npos)
        return std::string_view{};
    return line.substr(open + 1, close - open - 1);
}

void appendFile(ExpandedShader& shader, std::string_view name, std::string_view text) {
    const std::size_t file = shader.files.size();
    shader.files.emplace_back(name);
    fmt::format_to(std::back_inserter(shader.text), "#line 1 {}\n", file);
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const auto path = includedPath(line);
        if (!path) {
            shader.text.append(line).push_back('\n');
            continue;
        }
        const bool included =
            std::find(shader.files.begin(), shader.files.end(), *path) != shader.files.end();
        if (!included) {
            const auto library = libraryText(*path);
            if (!library)
                throw IncludeError(fmt::format("{}:{}: no file \"{}\" in the shader library", name,
                                               number, *path));
            appendFile(shader, *path, *library);
        }
        fmt::format_to(std::back_inserter(shader.text), "#line {} {}\n", number + 1, file);
    }
}

}  // namespace

std::optional<std::string_view> libraryText(std::string_view path) {
    const auto files = libraryFiles();
    const auto file = std::ranges::lower_bound(files, path, {}, &LibraryFile::path);
    if (file == files.end() || file->path != path)
        return std::nullopt;
    return file->text;
}

ExpandedShader expandShader(std::string_view name, std::string_view text, std::string_view header,
                            std::span<const Define> defines) {
    ExpandedShader shader;
    shader.text.append(header).push_back('\n');
    for (const Define& define : defines)
        fmt::format_to(std::back_inserter(shader.text), "#define {} {}\n", define.name,
                       define.value);
    appendFile(shader, name, text);
    return shader;
}

}  // namespace relievo::shaders

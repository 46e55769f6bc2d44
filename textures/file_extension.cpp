#include "textures/file_extension.h"

#include <fmt/format.h>

#include <algorithm>

#include "textures/input_error.h"

namespace relievo::textures {

std::string lowerExtension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return extension;
}

void requireExtensionFor(const std::filesystem::path& file, StorageFormat format) {
    const std::string extension = lowerExtension(file);
    const bool isPackedFile = extension == ".png" || extension == ".tif" || extension == ".tiff";
    if (isPackedFormat(format) ? isPackedFile : extension == ".exr")
        return;
    throw InputError(fmt::format("{}: cannot hold the format {}, expected the extension {}",
                                 file.string(), storageFormatName(format),
                                 isPackedFormat(format) ? ".png, .tif or .tiff" : ".exr"));
}

}  // namespace relievo::textures

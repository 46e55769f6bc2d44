#include "tests/viewer/map_fixture.h"

#include "relief_scene.h"
#include "textures/map_file.h"
#include "textures/sample_reliefs.h"

namespace relievo::tests {

void writeSampleMaps(const std::filesystem::path& file, std::string_view sample, int width,
                     int height, ConeChannel cones) {
    textures::MapSet maps = viewer::bakeMaps(textures::generateSampleRelief(sample, width, height));
    if (cones == ConeChannel::Missing)
        std::erase_if(maps.channels, [](const auto& channel) { return channel.name == "cone"; });
    textures::writeMapFile(file, maps, textures::StorageFormat::Float);
}

}  // namespace relievo::tests

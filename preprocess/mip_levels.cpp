#include "preprocess/mip_levels.h"

#include <utility>

#include "textures/halved_plane.h"

namespace relievo::preprocess {

std::vector<textures::DepthMap> reliefLevels(textures::DepthMap relief) {
    const double aspect = relief.aspect();
    std::vector<textures::DepthMap> levels;
    levels.push_back(std::move(relief));
    while (levels.back().width() > 1 || levels.back().height() > 1) {
        textures::DepthMap level{textures::halvedByArea(levels.back().depth), levels.front().wrap};
        level.texelAspect = aspect * level.width() / level.height();
        levels.push_back(std::move(level));
    }
    return levels;
}

}  // namespace relievo::preprocess

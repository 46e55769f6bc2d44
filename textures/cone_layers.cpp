#include "textures/cone_layers.h"

#include <fmt/core.h>

#include <string>

#include "textures/input_error.h"

namespace relievo::textures {

std::vector<const Plane*> coneLayersOf(const MapSet& maps) {
    if (const Plane* only = maps.find("cone"))
        return {only};
    std::vector<const Plane*> layers;
    while (const Plane* next = maps.find("cone" + std::to_string(layers.size())))
        layers.push_back(next);
    if (!layers.empty() && layers.size() != 4 && layers.size() != 8)
        throw InputError(
            fmt::format("has cones for {} sectors of directions, expected 4 or 8", layers.size()));
    return layers;
}

}  // namespace relievo::textures

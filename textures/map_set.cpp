#include "textures/map_set.h"

#include "textures/input_error.h"

namespace relievo::textures {

DepthMap depthMapOf(const MapSet& maps) {
    const Plane* depth = maps.find("depth");
    if (depth == nullptr)
        throw InputError("the map has no channel 'depth', which describes the relief itself");
    return DepthMap{*depth, maps.wrap, maps.texelAspect};
}

}  // namespace relievo::textures

#include "textures/roof_layers.h"

#include <fmt/core.h>

#include <charconv>
#include <optional>
#include <string>

#include "textures/input_error.h"

namespace relievo::textures {
namespace {

std::optional<RoofLayer> findLayer(const MapSet& maps, const std::string& suffix) {
    const RoofLayer layer{maps.find("roof" + suffix), maps.find("ratio" + suffix)};
    if (layer.roof == nullptr && layer.ratio == nullptr)
        return std::nullopt;
    if (layer.roof == nullptr || layer.ratio == nullptr)
        throw InputError(fmt::format("lacks the channel '{}{}', which goes with '{}{}'",
                                     layer.roof == nullptr ? "roof" : "ratio", suffix,
                                     layer.roof == nullptr ? "ratio" : "roof", suffix));
    return layer;
}

int blockOf(const MapSet& maps) {
    const auto found = maps.attributes.find("relievo:block");
    if (found == maps.attributes.end())
        return 1;
    const std::string& text = found->second;
    int block = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), block);
    if (error != std::errc() || stop != text.data() + text.size() || block < 1)
        throw InputError(fmt::format(
            "its attribute 'relievo:block' is '{}', expected a number of cells from 1", text));
    return block;
}

}  // namespace

RoofLayers roofLayersOf(const MapSet& maps) {
    RoofLayers roofs;
    if (const auto only = findLayer(maps, "")) {
        roofs.layers.push_back(*only);
    } else {
        while (const auto next = findLayer(maps, std::to_string(roofs.layers.size())))
            roofs.layers.push_back(*next);
    }
    const std::size_t count = roofs.layers.size();
    if (count == 0)
        return roofs;
    if (count != 1 && count != 4 && count != 8)
        throw InputError(fmt::format("has {} layers of roof cones, expected 1, 4 or 8", count));
    roofs.block = blockOf(maps);
    return roofs;
}

}  // namespace relievo::textures

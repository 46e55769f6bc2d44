#include "textures/shape_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "textures/input_error.h"
#include "textures/map_set.h"

namespace relievo::textures {
namespace {

constexpr const char* kSigned = "relievo:signed";
constexpr const char* kSlack = "relievo:slack";

const Plane& channelOf(const MapSet& maps, const char* name) {
    const Plane* plane = maps.find(name);
    if (plane == nullptr)
        throw InputError(fmt::format("the map has no channel '{}', which a shape needs", name));
    return *plane;
}

const std::string& attributeOf(const MapSet& maps, const char* name) {
    const auto found = maps.attributes.find(name);
    if (found == maps.attributes.end())
        throw InputError(fmt::format("the map has no attribute '{}', which a shape needs", name));
    return found->second;
}

bool signOf(const MapSet& maps) {
    const std::string& text = attributeOf(maps, kSigned);
    if (text != "0" && text != "1")
        throw InputError(fmt::format("{} is '{}', expected 0 or 1", kSigned, text));
    return text == "1";
}

double slackOf(const MapSet& maps) {
    const std::string& text = attributeOf(maps, kSlack);
    double slack = 0.0;
    const auto end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, slack);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(slack) || slack < 0.0)
        throw InputError(fmt::format("{} is '{}', expected a length of at least 0 in tile widths",
                                     kSlack, text));
    return slack;
}

}  // namespace

ShapeMap shapeMapOf(const MapSet& maps) {
    if (maps.kind != "shape")
        throw InputError(fmt::format("the map is of the kind '{}', expected 'shape'", maps.kind));
    ShapeMap shape{channelOf(maps, "distance"),
                   channelOf(maps, "gx"),
                   channelOf(maps, "gy"),
                   channelOf(maps, "shape"),
                   maps.wrap,
                   signOf(maps),
                   slackOf(maps)};
    if (!std::ranges::all_of(shape.distance.texels, [](float d) { return std::isfinite(d); }))
        throw InputError("the channel 'distance' has values that are not finite");
    return shape;
}

MapSet mapSetOf(const ShapeMap& shape) {
    MapSet maps;
    maps.kind = "shape";
    maps.wrap = shape.wrap;
    maps.attributes[kSigned] = fmt::format("{:d}", shape.isSigned);
    maps.attributes[kSlack] = fmt::format("{}", shape.slack);
    maps.channels = {{"gx", shape.gradientX},
                     {"gy", shape.gradientY},
                     {"distance", shape.distance},
                     {"shape", shape.shape}};
    return maps;
}

}  // namespace relievo::textures

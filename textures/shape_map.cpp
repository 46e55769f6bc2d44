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

void requireFinite(const Plane& plane, const char* name) {
    if (!std::ranges::all_of(plane.texels, [](float value) { return std::isfinite(value); }))
        throw InputError(fmt::format("the channel '{}' has values that are not finite", name));
}

ShapeCreases creasesOf(const MapSet& maps) {
    ShapeCreases creases{channelOf(maps, "crease"), channelOf(maps, "step")};
    requireFinite(creases.code, "crease");
    requireFinite(creases.step, "step");
    return creases;
}

void requireSafeSteps(const ShapeMap& shape) {
    for (std::size_t t = 0; t < shape.creases.step.texels.size(); ++t)
        if (!(shape.creases.step.texels[t] <= mostStep(shape, t)))
            throw InputError(
                "the channel 'step' is above what the channels 'distance' and 'crease' allow");
}

void requireCornersToEnd(const ShapeMap& shape) {
    const double most = (kCornersEndTexels - std::sqrt(2.0)) / shape.width();
    for (std::size_t t = 0; t < shape.creases.code.texels.size(); ++t)
        if (shape.creases.code.texels[t] != 0.0f && !shape.isReflex(t) &&
            static_cast<double>(shape.distance.texels[t]) > most)
            throw InputError(fmt::format(
                "the channel 'crease' has a convex corner {:.2f} texels outside of the shape, "
                "expected none beyond {:.2f}",
                static_cast<double>(shape.distance.texels[t]) * shape.width(),
                most * shape.width()));
}

}  // namespace

float mostStep(const ShapeMap& shape, std::size_t texel) noexcept {
    const float c = std::abs(shape.creases.code.texels[texel]);
    return shape.distance.texels[texel] - (shape.isReflex(texel) ? 0.0f : 0.5f * c);
}

double creaseDepth(const ShapeMap& shape) noexcept {
    double deepest = 0.0;
    for (std::size_t t = 0; t < shape.creases.code.texels.size(); ++t) {
        const double c = std::abs(static_cast<double>(shape.creases.code.texels[t]));
        const double reflex =
            shape.isReflex(t) ? std::max(0.0, c - kReflexTexels / shape.width()) : 0.0;
        const double below = static_cast<double>(shape.distance.texels[t]) -
                             static_cast<double>(shape.creases.step.texels[t]);
        deepest = std::max(deepest, below + 0.5 * reflex);
    }
    return deepest;
}

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
    requireFinite(shape.distance, "distance");
    if (maps.find("crease") != nullptr)
        shape.creases = creasesOf(maps);
    requireSafeSteps(shape);
    requireCornersToEnd(shape);
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
    if (shape.isCreased()) {
        maps.channels.push_back({"crease", shape.creases.code});
        maps.channels.push_back({"step", shape.creases.step});
    }
    return maps;
}

}  // namespace relievo::textures

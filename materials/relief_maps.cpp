#include "materials/relief_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <vector>

#include "materials/ellipse_moments.h"
#include "materials/slope_moments.h"
#include "textures/cone_layers.h"
#include "textures/depth_pyramid.h"
#include "textures/displacement_table.h"
#include "textures/input_error.h"
#include "textures/roof_layers.h"

namespace relievo::materials {
namespace {

constexpr std::string_view kDepthChannels[] = {"depth"};
constexpr std::string_view kDerivativeChannels[] = {"dx", "dy"};
constexpr std::string_view kNormalChannels[] = {"nx", "ny", "nz"};
constexpr std::string_view kConeChannels[] = {"cone"};
constexpr std::string_view kRoofChannels[] = {"roof", "ratio"};

constexpr std::string_view kVolumeChannels[] = {"volume"};
constexpr std::string_view kExtremaChannels[] = {"dmin", "dmax"};
constexpr std::string_view kCylinderChannels[] = {"cylinder"};
constexpr std::string_view kDisplacementChannels[] = {"vdmfactor0"};
constexpr std::string_view kHorizonChannels[] = {"horizon"};
constexpr std::string_view kEllipseChannels[] = {"ellipsex", "ellipsey", "ellipsea", "ellipseb",
                                                 "ellipseangle"};

// What belongs to its texel is not filtered: between two cones neither is valid, let alone their
// mean.
constexpr ReliefMapFormat kFormats[] = {
    {.name = "depth",
     .sampler = "relievoDepthMap",
     .channels = kDepthChannels,
     .internalFormat = GL_R32F,
     .filter = GL_LINEAR},
    {.name = "derivative",
     .sampler = "relievoDerivativeMap",
     .channels = kDerivativeChannels,
     .internalFormat = GL_RG32F,
     .filter = GL_LINEAR,
     .blendsLevels = true},
    {.name = "normal",
     .sampler = "relievoNormalMap",
     .channels = kNormalChannels,
     .internalFormat = GL_RGB32F,
     .filter = GL_LINEAR,
     .number = {"relievo:normal-scale", "relievoNormalScale", false, 0.0},
     .blendsLevels = true},
    {.name = "cone",
     .sampler = "relievoConeMap",
     .channels = kConeChannels,
     .internalFormat = GL_R32F,
     .filter = GL_NEAREST,
     .form = ReliefMapForm::PlaneOrSectors,
     .cones = "conservative"},
    {.name = "relaxed-cone",
     .sampler = "relievoConeMap",
     .channels = kConeChannels,
     .internalFormat = GL_R32F,
     .filter = GL_NEAREST,
     .form = ReliefMapForm::PlaneOrSectors,
     .cones = "relaxed"},
    {.name = "roof",
     .sampler = "relievoRoofMap",
     .channels = kRoofChannels,
     .internalFormat = GL_RG32F,
     .filter = GL_NEAREST,
     .form = ReliefMapForm::Sectors,
     .cones = "roof",
     .number = {"relievo:block", "relievoRoofBlock", true, 1.0}},
    {.name = "pyramid",
     .sampler = "relievoPyramidMap",
     .channels = kDepthChannels,
     .internalFormat = GL_R32F,
     .filter = GL_NEAREST,
     .form = ReliefMapForm::Pyramid},
    {.name = "volume",
     .sampler = "relievoVolumeMap",
     .channels = kVolumeChannels,
     .internalFormat = GL_R32F,
     .filter = GL_NEAREST,
     .form = ReliefMapForm::Numbered,
     .number = {"relievo:volume-scale", "relievoVolumeScale", false, 0.1}},
    {.name = "extrema",
     .sampler = "relievoExtremaMap",
     .channels = kExtremaChannels,
     .internalFormat = GL_RG32F,
     .filter = GL_NEAREST,
     .number = {"relievo:reach", "relievoReach", true, 4.0}},
    {.name = "cylinder",
     .sampler = "relievoCylinderMap",
     .channels = kCylinderChannels,
     .internalFormat = GL_R32F,
     .filter = GL_NEAREST},
    {.name = "vdm",
     .sampler = "relievoDisplacementMap",
     .channels = kDisplacementChannels,
     .internalFormat = GL_RGBA32F,
     .filter = GL_LINEAR,
     .form = ReliefMapForm::Displacements,
     .number = {"relievo:vdm-scale", "relievoDisplacementScale", false, 0.1}},
    {.name = "vdm-weights",
     .sampler = "relievoDisplacementWeights",
     .channels = kDisplacementChannels,
     .internalFormat = GL_RGBA32F,
     .filter = GL_LINEAR,
     .form = ReliefMapForm::DisplacementWeights},
    {.name = "horizon",
     .sampler = "relievoHorizonMap",
     .channels = kHorizonChannels,
     .internalFormat = GL_R32F,
     .filter = GL_LINEAR,
     .form = ReliefMapForm::Numbered},
    {.name = "ellipse",
     .sampler = "relievoEllipseMap",
     .channels = kEllipseChannels,
     .internalFormat = GL_RGB32F,
     .filter = GL_LINEAR,
     .form = ReliefMapForm::Ellipses,
     .number = {"relievo:normal-scale", "relievoEllipseScale", false, 0.0}},
    {.name = "slope-moments",
     .sampler = "relievoMomentMap",
     .channels = kDepthChannels,
     .internalFormat = GL_RGB32F,
     .filter = GL_LINEAR,
     .form = ReliefMapForm::SlopeMoments,
     .blendsLevels = true},
};

// Unlimited cones are infinite in memory, which a shader would turn into NaN (∞·0). This is as
// good: it leads out of any window in one step.
constexpr float kLargestUpload = 1e30f;

void uploadLayer(std::span<const textures::Plane* const> channels, gl::Texture& texture, int layer,
                 int level) {
    const std::size_t count = channels.size();
    std::vector<float> texels(channels.front()->texels.size() * count);
    for (std::size_t k = 0; k < texels.size(); ++k)
        texels[k] = std::min(channels[k % count]->texels[k / count], kLargestUpload);
    texture.upload(texels, static_cast<int>(count), layer, level);
}

// The planes of the layers of an array; channels of one layer are r, g, b, a.
using Layers = std::vector<std::vector<const textures::Plane*>>;

// The terms of a table of displacements go four by four.
constexpr std::size_t kTermsOfATexel = 4;

std::size_t termGroups(const textures::DisplacementTable& table) {
    return (table.terms() + kTermsOfATexel - 1) / kTermsOfATexel;
}

// What has no map of its own in a file.
bool isMadeOfOthers(const ReliefMapFormat& format) {
    return format.form == ReliefMapForm::Pyramid || format.form == ReliefMapForm::SlopeMoments ||
           format.form == ReliefMapForm::DisplacementWeights;
}

// What `read` returns; the errors that it throws have no file name yet.
template <typename Read>
auto readFrom(std::string_view file, const Read& read) {
    try {
        return read();
    } catch (const textures::InputError& error) {
        throw textures::InputError(fmt::format("{}: {}", file, error.what()));
    }
}

// How to bake a map that is missing.
std::string remedy(const ReliefMapFormat& format) {
    return fmt::format("bake it with relievo-bake relief --maps …,{}",
                       format.cones.empty() ? std::string(format.name)
                                            : fmt::format("cone --cone {}", format.cones));
}

// The kind of the cones in channel `cone`; other tools than ours make conservative ones.
std::string coneKindOf(const textures::MapSet& maps) {
    const auto found = maps.attributes.find("relievo:cone");
    return found == maps.attributes.end() ? "conservative" : found->second;
}

// OpenGL samples levels of these sizes only.
void requireWholeChain(std::span<const textures::MapSet> levels, std::string_view name) {
    if (levels.size() == 1)
        return;
    for (std::size_t k = 1; k < levels.size(); ++k) {
        const int width = std::max(levels[k - 1].width() / 2, 1);
        const int height = std::max(levels[k - 1].height() / 2, 1);
        if (levels[k].width() != width || levels[k].height() != height)
            throw textures::InputError(
                fmt::format("{}: its MIP level {} has {} x {} texels, expected {} x {}", name, k,
                            levels[k].width(), levels[k].height(), width, height));
    }
    if (levels.back().width() != 1 || levels.back().height() != 1)
        throw textures::InputError(
            fmt::format("{}: its last MIP level has {} x {} texels, expected 1 x 1", name,
                        levels.back().width(), levels.back().height()));
}

GLenum levelFilter(const ReliefMapFormat& format) {
    if (format.filter == GL_NEAREST)
        return GL_NEAREST_MIPMAP_NEAREST;
    return format.blendsLevels ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST;
}

}  // namespace

std::span<const ReliefMapFormat> reliefMapFormats() {
    return kFormats;
}

const ReliefMapFormat& reliefMapFormat(std::string_view name) {
    const auto found = std::ranges::find(kFormats, name, &ReliefMapFormat::name);
    assert(found != std::end(kFormats));
    return *found;
}

BakeWords bakeWordsFor(std::span<const std::string_view> mapNames) {
    BakeWords words{{"depth", "derivative"}, ""};
    for (const std::string_view name : mapNames) {
        const ReliefMapFormat& format = reliefMapFormat(name);
        if (!format.cones.empty()) {
            words.maps.emplace_back("cone");
            words.cones = format.cones;
        } else if (!isMadeOfOthers(format) &&
                   std::ranges::find(words.maps, name) == words.maps.end()) {
            words.maps.emplace_back(name);
        }
    }
    return words;
}

ReliefMaps::ReliefMaps(textures::MapSet maps, std::string name)
    : ReliefMaps(std::vector<textures::MapSet>{std::move(maps)}, std::move(name)) {}

ReliefMaps::ReliefMaps(std::vector<textures::MapSet> levels, std::string name)
    : levels_(std::move(levels)), name_(std::move(name)) {
    assert(!levels_.empty());
    requireWholeChain(levels_, name_);
    require("depth");
    const auto [least, greatest] = std::ranges::minmax_element(maps().find("depth")->texels);
    depthRange_ = {*least, *greatest};
}

std::vector<const textures::Plane*> ReliefMaps::channelsOf(const ReliefMapFormat& format,
                                                           const textures::MapSet& maps) const {
    std::vector<const textures::Plane*> planes;
    for (const std::string_view channel : format.channels) {
        planes.push_back(maps.find(channel));
        if (planes.back() == nullptr)
            throw missing(format, channel);
    }
    requireConeKind(format, maps);
    return planes;
}

void ReliefMaps::requireConeKind(const ReliefMapFormat& format,
                                 const textures::MapSet& maps) const {
    if (!format.cones.empty() && format.cones != coneKindOf(maps))
        throw textures::InputError(fmt::format("{}: holds {} cones, expected {} ones; {}", name_,
                                               coneKindOf(maps), format.cones, remedy(format)));
}

Layers ReliefMaps::surfaceCones(const ReliefMapFormat& format, const textures::MapSet& maps) const {
    Layers layers;
    for (const textures::Plane* ratio :
         readFrom(name_, [&] { return textures::coneLayersOf(maps); }))
        layers.push_back({ratio});
    if (!layers.empty())
        requireConeKind(format, maps);
    return layers;
}

int ReliefMaps::coneSectors() const {
    return static_cast<int>(readFrom(name_, [&] { return textures::coneLayersOf(maps()); }).size());
}

Layers ReliefMaps::sectors(const textures::MapSet& maps) const {
    const textures::RoofLayers roofs =
        readFrom(name_, [&] { return textures::roofLayersOf(maps); });
    Layers layers;
    for (const textures::RoofLayer& layer : roofs.layers)
        layers.push_back({layer.roof, layer.ratio});
    return layers;
}

Layers ReliefMaps::displacements(const textures::MapSet& maps) const {
    const textures::DisplacementTable table =
        readFrom(name_, [&] { return textures::displacementTableOf(maps); });
    Layers layers;
    const auto azimuths = static_cast<std::size_t>(table.azimuths);
    for (std::size_t azimuth = 0; azimuth < azimuths; ++azimuth)
        for (std::size_t group = 0; group < termGroups(table); ++group) {
            auto& layer = layers.emplace_back();
            for (std::size_t k = 0; k < kTermsOfATexel; ++k) {
                // What fills up the last group has no weight.
                const std::size_t term = std::min(group * kTermsOfATexel + k, table.terms() - 1);
                layer.push_back(table.factors[term * azimuths + azimuth]);
            }
        }
    return layers;
}

Layers ReliefMaps::layersOf(const ReliefMapFormat& format, const textures::MapSet& maps) const {
    Layers layers;
    switch (format.form) {
        case ReliefMapForm::Sectors:
            layers = sectors(maps);
            break;
        case ReliefMapForm::PlaneOrSectors:
            layers = surfaceCones(format, maps);
            break;
        case ReliefMapForm::Numbered:
            while (const textures::Plane* slice =
                       maps.find(fmt::format("{}{}", format.channels.front(), layers.size())))
                layers.push_back({slice});
            break;
        case ReliefMapForm::Displacements:
        case ReliefMapForm::DisplacementWeights:
            layers = displacements(maps);
            break;
        case ReliefMapForm::Plane:
        case ReliefMapForm::Pyramid:
        case ReliefMapForm::Ellipses:
        case ReliefMapForm::SlopeMoments:
            layers.push_back(channelsOf(format, maps));
            break;
    }
    if (layers.empty())
        throw missing(format, format.channels.front());
    return layers;
}

textures::InputError ReliefMaps::missing(const ReliefMapFormat& format,
                                         std::string_view channel) const {
    return textures::InputError(fmt::format("{}: no channel \"{}\", which is needed here; {}",
                                            name_, channel, remedy(format)));
}

void ReliefMaps::require(std::string_view mapName) const {
    static_cast<void>(layersOf(reliefMapFormat(mapName), maps()));
}

bool ReliefMaps::has(std::string_view mapName) const noexcept {
    const auto channels = reliefMapFormat(mapName).channels;
    return std::ranges::all_of(
        channels, [&](std::string_view channel) { return maps().find(channel) != nullptr; });
}

double ReliefMaps::number(std::string_view mapName) const {
    const ReliefMapNumber& number = reliefMapFormat(mapName).number;
    const auto found = maps().attributes.find(std::string(number.attribute));
    if (found == maps().attributes.end()) {
        if (number.attribute.empty() || number.otherwise > 0.0)
            return number.otherwise;
        throw textures::InputError(
            fmt::format("{}: no attribute '{}', without which its map '{}' has no meaning", name_,
                        number.attribute, mapName));
    }
    const std::string& text = found->second;
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = std::nearbyint(value) == value;
    if (error != std::errc() || stop != text.data() + text.size() || !(value > 0.0) ||
        !std::isfinite(value) || (number.isInteger && !isWhole))
        throw textures::InputError(
            fmt::format("{}: its attribute '{}' is '{}', expected {} above 0", name_,
                        number.attribute, text, number.isInteger ? "a whole number" : "a number"));
    return value;
}

const gl::Texture& ReliefMaps::texture(std::string_view mapName) {
    const ReliefMapFormat& format = reliefMapFormat(mapName);
    if (const auto found = textures_.find(format.name); found != textures_.end())
        return found->second;
    return textures_.emplace(format.name, upload(format)).first->second;
}

gl::Texture ReliefMaps::upload(const ReliefMapFormat& format) const {
    switch (format.form) {
        case ReliefMapForm::Pyramid:
            return uploadPyramid(format);
        case ReliefMapForm::Ellipses:
            return uploadEllipses(format);
        case ReliefMapForm::SlopeMoments:
            return uploadMoments(format);
        case ReliefMapForm::DisplacementWeights:
            return uploadWeights(format);
        case ReliefMapForm::Displacements:
        case ReliefMapForm::Plane:
        case ReliefMapForm::PlaneOrSectors:
        case ReliefMapForm::Sectors:
        case ReliefMapForm::Numbered:
            break;
    }
    return uploadLayers(format);
}

gl::Texture ReliefMaps::uploadEllipses(const ReliefMapFormat& format) const {
    const EllipseMoments moments = ellipseMoments(channelsOf(format, maps()));
    gl::Texture texture(maps().width(), maps().height(), format.internalFormat, 2);
    texture.upload(moments.centres, 3, 0);
    texture.upload(moments.squares, 3, 1);
    texture.setSampling(glWrapMode(maps().wrap), format.filter);
    return texture;
}

gl::Texture ReliefMaps::uploadMoments(const ReliefMapFormat& format) const {
    const std::vector<SlopeMoments> levels = slopeMoments(textures::depthMapOf(maps()));
    assert(!levels.empty());
    const textures::Plane& largest = levels.front().xx;
    gl::Texture texture(largest.width, largest.height, format.internalFormat, 0,
                        static_cast<int>(levels.size()));
    for (std::size_t level = 0; level < levels.size(); ++level)
        uploadLayer(std::array{&levels[level].xx, &levels[level].xy, &levels[level].yy}, texture, 0,
                    static_cast<int>(level));
    texture.setSampling(glWrapMode(maps().wrap), format.filter);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER,
                        static_cast<GLint>(levelFilter(format)));
    return texture;
}

gl::Texture ReliefMaps::uploadLayers(const ReliefMapFormat& format) const {
    const int count = static_cast<int>(layersOf(format, maps()).size());
    const bool isArray = format.form != ReliefMapForm::Plane &&
                         (format.form != ReliefMapForm::PlaneOrSectors || count > 1);
    gl::Texture texture(maps().width(), maps().height(), format.internalFormat, isArray ? count : 0,
                        levelCount());
    for (int level = 0; level < levelCount(); ++level) {
        const auto layers = layersOf(format, levels_[static_cast<std::size_t>(level)]);
        if (layers.size() != static_cast<std::size_t>(count))
            throw textures::InputError(fmt::format(
                "{}: its MIP level {} has {} layers of the map {}, expected {} as in the first one",
                name_, level, layers.size(), format.name, count));
        for (int layer = 0; layer < count; ++layer)
            uploadLayer(layers[static_cast<std::size_t>(layer)], texture, layer, level);
    }
    texture.setSampling(glWrapMode(maps().wrap), format.filter);
    if (levelCount() > 1)
        glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER,
                            static_cast<GLint>(levelFilter(format)));
    return texture;
}

gl::Texture ReliefMaps::uploadPyramid(const ReliefMapFormat& format) const {
    const textures::Plane cells = textures::leastDepthsOfCells(textures::depthMapOf(maps()));
    textures::Plane padded(static_cast<int>(std::bit_ceil(static_cast<unsigned>(cells.width))),
                           static_cast<int>(std::bit_ceil(static_cast<unsigned>(cells.height))),
                           1.0f);
    for (int j = 0; j < cells.height; ++j)
        for (int i = 0; i < cells.width; ++i)
            padded.at(i, j) = cells.at(i, j);
    const auto levels = textures::buildDepthPyramid(padded).levels;
    gl::Texture texture(padded.width, padded.height, format.internalFormat, 0,
                        static_cast<int>(levels.size()));
    for (std::size_t level = 0; level < levels.size(); ++level)
        texture.upload(levels[level].texels, 1, 0, static_cast<int>(level));
    texture.setSampling(GL_CLAMP_TO_EDGE, format.filter);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    return texture;
}

gl::Texture ReliefMaps::uploadWeights(const ReliefMapFormat& format) const {
    const textures::DisplacementTable table =
        readFrom(name_, [&] { return textures::displacementTableOf(maps()); });
    const std::size_t width = termGroups(table);
    std::vector<float> texels(width * kTermsOfATexel * table.weights.size(), 0.0f);
    for (std::size_t row = 0; row < table.weights.size(); ++row)
        std::ranges::copy(table.weights[row], texels.begin() + static_cast<std::ptrdiff_t>(
                                                                   row * width * kTermsOfATexel));
    gl::Texture texture(static_cast<int>(width), static_cast<int>(table.weights.size()),
                        format.internalFormat);
    texture.upload(texels, static_cast<int>(kTermsOfATexel));
    texture.setSampling(GL_CLAMP_TO_EDGE, format.filter);
    return texture;
}

GLenum glWrapMode(textures::WrapMode wrap) noexcept {
    switch (wrap) {
        case textures::WrapMode::Repeat:
            return GL_REPEAT;
        case textures::WrapMode::Mirror:
            return GL_MIRRORED_REPEAT;
        case textures::WrapMode::Clamp:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

}  // namespace relievo::materials

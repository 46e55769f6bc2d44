#pragma once

#include <glad/gl.h>

#include <glm/vec2.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/texture.h"
#include "textures/input_error.h"
#include "textures/map_set.h"

namespace relievo::materials {

/// What a map is on the GPU.
enum class ReliefMapForm {
    Plane,  ///< a sampler2D with the map's channels
    /// A sampler2DArray with a layer for each sector of ray directions, whose channels have its
    /// number (none when there is one sector): roof0, ratio0, roof1 …
    Sectors,
    /// A sampler2D with the map's only channel, or with several sectors a sampler2DArray as above,
    /// whose channels have the number of their sector: cone0, cone1 …
    PlaneOrSectors,
    /// A sampler2DArray with a layer for each slice of depth, or azimuth, whose channel has its
    /// number: volume0, volume1 …
    Numbered,
    /// A sampler2D whose levels are the pyramid of least depths of the map's cells, made of the
    /// channel `depth` when it is uploaded. Sizes are those of the map rounded up to powers of two,
    /// so that a node of any level is a texel; texels beyond the map are 1.
    Pyramid,
    /// A sampler2DArray with the factors of a textures::DisplacementTable: the terms four by four,
    /// as r, g, b, a of a layer, all of the first azimuth, then all of the next.
    Displacements,
    /// A sampler2D with the weights of that table, a row for each elevation and four terms a texel.
    DisplacementWeights,
    /// A sampler2DArray with the centres and the squares of visibility ellipses
    /// (ellipse_moments.h), of the first MIP level.
    Ellipses,
    /// A sampler2D with the second moments of the slopes (slope_moments.h), made of the channel
    /// `depth`; its first level belongs to the second one of the relief.
    SlopeMoments,
};

/// A number that a search needs besides the texels of a map, kept in the map file.
struct ReliefMapNumber {
    std::string_view attribute;  ///< "relievo:block"; empty: there is none
    std::string_view uniform;    ///< in the shader library
    bool isInteger = false;
    /// What it is for a file without the attribute; 0: the file must have it.
    double otherwise = 0.0;
};

/// How one map of a relief goes to the GPU. Adding a map kind is an entry in relief_maps.cpp.
struct ReliefMapFormat {
    std::string_view name;                       ///< "depth", "derivative", "cone", "roof"
    std::string_view sampler;                    ///< in the shader library
    std::span<const std::string_view> channels;  ///< of the map set, in the order r, g, b, a
    GLenum internalFormat;
    GLenum filter;
    ReliefMapForm form = ReliefMapForm::Plane;
    /// The kind of cones that the channels hold, a word of relievo-bake relief --cone; "" for maps
    /// without cones.
    std::string_view cones = "";
    ReliefMapNumber number = {};
    /// Whether a lookup between two MIP levels mixes them. A search stays in one of them.
    bool blendsLevels = false;
};

/// All maps that can go to the GPU.
std::span<const ReliefMapFormat> reliefMapFormats();

/// The format of the map called `name`; the name must be one of reliefMapFormats().
const ReliefMapFormat& reliefMapFormat(std::string_view name);

/// What relievo-bake relief must be told for a search that reads certain maps, and its shading.
struct BakeWords {
    std::vector<std::string> maps;  ///< of --maps
    std::string cones;              ///< of --cone; empty: no cones
};
BakeWords bakeWordsFor(std::span<const std::string_view> mapNames);

/// The maps of one relief on the GPU. Each is uploaded when it is first asked for, so maps that no
/// technique in use needs cost nothing. Needs a current context; share it between the materials
/// that show the same relief.
class ReliefMaps {
  public:
    /// `name` stands for the relief in error messages (usually its file). Throws
    /// textures::InputError when `maps` has no channel `depth`.
    ReliefMaps(textures::MapSet maps, std::string name);
    /// A relief with its MIP levels, the first one first, as textures::readMapLevels gives them:
    /// either that one alone, or each of half the size of the one before, rounded down, to 1×1.
    /// Throws textures::InputError for other sizes.
    ReliefMaps(std::vector<textures::MapSet> levels, std::string name);

    /// The texture of one map. Throws textures::InputError that names the channel the set lacks, or
    /// the kind of cones that it has instead of the one needed.
    const gl::Texture& texture(std::string_view mapName);
    /// The number that belongs to a map which has one. Throws textures::InputError when the file
    /// has something else, or 0 or less, or lacks it where nothing can be assumed.
    [[nodiscard]] double number(std::string_view mapName) const;
    /// Throws what `texture` would, without uploading anything.
    void require(std::string_view mapName) const;
    /// Whether the set has the channels of a map.
    [[nodiscard]] bool has(std::string_view mapName) const noexcept;

    /// How many sectors of directions the cones on the surface tell apart; 0 without such cones.
    [[nodiscard]] int coneSectors() const;

    /// Of the first level.
    [[nodiscard]] const textures::MapSet& maps() const noexcept { return levels_.front(); }
    /// MIP levels, from 1.
    [[nodiscard]] int levelCount() const noexcept { return static_cast<int>(levels_.size()); }
    /// The least and the greatest depth of the relief.
    [[nodiscard]] glm::vec2 depthRange() const noexcept { return depthRange_; }

  private:
    /// The planes of each array layer of a map, or of its only one, in one level.
    [[nodiscard]] std::vector<std::vector<const textures::Plane*>> layersOf(
        const ReliefMapFormat& format, const textures::MapSet& maps) const;
    [[nodiscard]] std::vector<std::vector<const textures::Plane*>> sectors(
        const textures::MapSet& maps) const;
    [[nodiscard]] std::vector<std::vector<const textures::Plane*>> surfaceCones(
        const ReliefMapFormat& format, const textures::MapSet& maps) const;
    void requireConeKind(const ReliefMapFormat& format, const textures::MapSet& maps) const;
    [[nodiscard]] std::vector<std::vector<const textures::Plane*>> displacements(
        const textures::MapSet& maps) const;
    [[nodiscard]] std::vector<const textures::Plane*> channelsOf(
        const ReliefMapFormat& format, const textures::MapSet& maps) const;
    [[nodiscard]] gl::Texture uploadLayers(const ReliefMapFormat& format) const;
    [[nodiscard]] gl::Texture uploadPyramid(const ReliefMapFormat& format) const;
    [[nodiscard]] gl::Texture uploadWeights(const ReliefMapFormat& format) const;
    [[nodiscard]] gl::Texture uploadEllipses(const ReliefMapFormat& format) const;
    [[nodiscard]] gl::Texture uploadMoments(const ReliefMapFormat& format) const;
    [[nodiscard]] gl::Texture upload(const ReliefMapFormat& format) const;
    [[nodiscard]] textures::InputError missing(const ReliefMapFormat& format,
                                               std::string_view channel) const;

    std::vector<textures::MapSet> levels_;
    std::string name_;
    glm::vec2 depthRange_;
    std::map<std::string_view, gl::Texture> textures_;
};

/// GL_REPEAT, GL_MIRRORED_REPEAT or GL_CLAMP_TO_EDGE.
GLenum glWrapMode(textures::WrapMode wrap) noexcept;

}  // namespace relievo::materials

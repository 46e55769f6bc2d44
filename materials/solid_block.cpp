#include "materials/solid_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "materials/profile_bounds.h"
#include "shaders/relievo/constants.h"
#include "textures/input_error.h"

namespace relievo::materials {
namespace {

static_assert(solids::kMostParts == RELIEVO_SOLID_MOST_PARTS);
static_assert(solids::kMostPieces == RELIEVO_SOLID_MOST_PIECES);
static_assert(textures::kReflexTexels == RELIEVO_SOLID_CREASE);
static_assert(textures::kLeastReflexTexels == RELIEVO_SOLID_LEAST_REFLEX);
static_assert(textures::kCornersEndTexels == RELIEVO_SOLID_CORNERS_END);
static_assert(static_cast<int>(solids::SolidTexturing::Box) == RELIEVO_TEXTURING_BOX);

struct PartBlock {
    glm::mat4 fromWhole;
    glm::vec4 windowMinimum;
    glm::vec4 windowMaximum;
    glm::vec4 section;
    glm::ivec4 ways;
    glm::vec4 color;
};
static_assert(sizeof(PartBlock) == 9 * 16);

struct PieceBlock {
    glm::vec4 line;
    glm::vec4 normals;
    glm::vec4 chords;
    glm::vec4 extremes;
    glm::vec4 limits;
};
static_assert(sizeof(PieceBlock) == 5 * 16);

using PieceBlocks = std::array<PieceBlock, solids::kMostPieces>;

int wrapNumber(textures::WrapMode wrap) {
    switch (wrap) {
        case textures::WrapMode::Repeat:
            return RELIEVO_SOLID_REPEAT;
        case textures::WrapMode::Mirror:
            return RELIEVO_SOLID_MIRROR;
        case textures::WrapMode::Clamp:
            break;
    }
    return RELIEVO_SOLID_CLAMP;
}

int operationNumber(solids::BooleanOperation operation) {
    switch (operation) {
        case solids::BooleanOperation::Union:
            return RELIEVO_SOLID_UNION;
        case solids::BooleanOperation::Intersection:
            return RELIEVO_SOLID_INTERSECTION;
        case solids::BooleanOperation::Difference:
            break;
    }
    return RELIEVO_SOLID_DIFFERENCE;
}

glm::vec4 toVector(const std::array<double, kProfileWays>& ways, double scale) {
    return scale * glm::dvec4(ways[0], ways[1], ways[2], ways[3]);
}

// Offsets in texels of a map that is `width` of them wide.
PieceBlock pieceBlock(const solids::ProfilePiece& piece, const ProfileBounds& bounds,
                      double width) {
    // Of a straight piece the normal is that of the offset in tile widths; both of its components
    // are lengths per tile width and per unit of depth.
    return {glm::vec4(piece.top, piece.bottom, width * piece.topOffset, width * piece.slope()),
            glm::vec4(piece.topNormal, piece.bottomNormal), toVector(bounds.chord, width),
            toVector(bounds.extreme, width), toVector(bounds.limit, 1.0)};
}

PartBlock partBlock(const solids::SolidPart& part, const PartLook& look) {
    const textures::ShapeMap& shape = *part.solid.shape;
    const double width = shape.width();
    return {glm::mat4(part.fromWhole),
            glm::vec4(part.windowMinimum, width * textures::creaseDepth(shape)),
            glm::vec4(part.windowMaximum, 1.0 / width),
            glm::vec4(part.solid.axis, width * part.solid.extension, width * shape.slack),
            glm::ivec4(static_cast<int>(part.solid.profile.pieces.size()), wrapNumber(shape.wrap),
                       operationNumber(part.operation), static_cast<int>(look.texturing)),
            glm::vec4(look.color, 1.0f)};
}

PieceBlocks pieceBlocks(const solids::SolidPart& part) {
    const std::vector<solids::ProfilePiece>& pieces = part.solid.profile.pieces;
    if (pieces.empty() || pieces.size() > solids::kMostPieces)
        throw textures::InputError(fmt::format("a profile of {} pieces, expected 1 to {}",
                                               pieces.size(), solids::kMostPieces));
    const std::vector<ProfileBounds> bounds = profileBounds(part.solid.profile);
    PieceBlocks blocks{};
    for (std::size_t k = 0; k < pieces.size(); ++k)
        blocks[k] = pieceBlock(pieces[k], bounds[k], part.solid.shape->width());
    return blocks;
}

template <typename Block>
void append(std::vector<std::byte>& bytes, const Block& block) {
    const std::size_t size = bytes.size();
    bytes.resize(size + sizeof(Block));
    std::memcpy(bytes.data() + size, &block, sizeof(Block));
}

}  // namespace

std::vector<std::byte> solidBlock(const solids::Compound& compound,
                                  std::span<const PartLook> looks) {
    assert(looks.size() == compound.parts.size());
    if (compound.parts.empty() || compound.parts.size() > solids::kMostParts)
        throw textures::InputError(fmt::format("a solid of {} parts, expected 1 to {}",
                                               compound.parts.size(), solids::kMostParts));
    std::vector<std::byte> bytes;
    for (std::size_t k = 0; k < compound.parts.size(); ++k)
        append(bytes, partBlock(compound.parts[k], looks[k]));
    for (const solids::SolidPart& part : compound.parts)
        append(bytes, pieceBlocks(part));
    return bytes;
}

}  // namespace relievo::materials

#pragma once

#include <string>

#include "textures/storage_format.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// How to bake a shape map, in the words of `relievo-bake shape`.
struct ShapePlan {
    textures::WrapMode wrap = textures::WrapMode::Repeat;
    /// White is inside instead of black. Of drawings and text: all but what they fill.
    bool isWhiteInside = false;
    /// Distances of both signs, 0 on the outline; else those to the nearest texel whose centre is
    /// inside, and 0 inside.
    bool isSigned = true;
    /// Whether corners stay sharp, by textures::ShapeCreases: of signed maps in Float or Half.
    bool hasSharpCorners = true;
    /// 0: exact directions from the nearest point of the outline; else the size of Prewitt's
    /// kernel: 3, 5, 7 or 9.
    int gradient = 0;
    /// Texels of the map of a drawing; a height of 0 is chosen to make texels square. Bitmaps have
    /// their own size.
    int width = 512;
    int height = 0;
    std::string channel;  ///< of bitmaps, as in HeightImageOptions
    /// What the file will hold: distances are rounded to it, and slack says by how much.
    textures::StorageFormat format = textures::StorageFormat::Float;

    [[nodiscard]] bool hasCreases() const {
        return hasSharpCorners && isSigned && !textures::isPackedFormat(format);
    }
};

}  // namespace relievo::preprocess

#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "reference/plane_outline.h"
#include "solids/solid.h"
#include "textures/shape_map.h"
#include "textures/storage_format.h"

namespace relievo::viewer {

using ShapePointer = std::shared_ptr<const textures::ShapeMap>;

/// How a sample shape is baked.
struct ShapeBaking {
    int width = 128;
    int height = 128;
    textures::WrapMode wrap = textures::WrapMode::Repeat;
    bool isSigned = true;
    textures::StorageFormat format = textures::StorageFormat::Float;
};

/// A shape of reference::sampleShapes or reference::sampleSections, "letters" (of a font; the
/// height follows), or "noise": texels that are inside or not at random. Baked once for each
/// baking.
ShapePointer sampleShape(std::string_view name, const ShapeBaking& baking = {});

/// The outline that such a shape has, unless it is "noise", in tile widths.
reference::PlaneOutline sampleOutline(std::string_view name);

/// A solid, and how it is looked at: from the surface that it is sunk into, or in its box.
struct SolidCase {
    std::string name;
    solids::Compound compound;
    bool isInBox = false;
    glm::dvec3 low{0.0};  ///< of the box, or of the window of the surface
    glm::dvec3 high{1.0};
    double depth = 0.3;  ///< of z = 1, in tile widths
};

/// Extrusions of every profile, wrap mode, sign and format; revolutions; compounds.
std::vector<SolidCase> extrusionCases();
std::vector<SolidCase> revolutionCases();
std::vector<SolidCase> compoundCases();

}  // namespace relievo::viewer

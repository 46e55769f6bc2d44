#include "solid_samples.h"

#include <fmt/format.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <random>
#include <tuple>

#include "outlines/text_outline.h"
#include "preprocess/shape_baker.h"
#include "reference/sample_outlines.h"

namespace relievo::viewer {
namespace {

using solids::BooleanOperation;
using solids::makeProfile;
using solids::Profile;
using solids::ProfileShape;
using solids::SolidKind;
using solids::SolidPart;
using textures::StorageFormat;
using textures::WrapMode;

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf";
constexpr double kInfinity = std::numeric_limits<double>::infinity();

textures::Plane noise(int width, int height) {
    textures::Plane plane(width, height);
    std::mt19937 random(4711);
    for (float& texel : plane.texels)
        texel = random() % 3 == 0 ? 1.0f : 0.0f;
    plane.texels.front() = 1.0f;
    return plane;
}

outlines::Drawing drawing(std::string_view name) {
    if (name == "letters")
        return outlines::readTextDrawing(kFont, "&Ag", 1e-5);
    for (const auto& samples : {reference::sampleShapes(), reference::sampleSections()})
        for (const reference::SampleOutline& sample : samples)
            if (sample.name == name)
                return {{{sample.contours, sample.filling == reference::Filling::NonZero
                                               ? outlines::FillRule::NonZero
                                               : outlines::FillRule::EvenOdd}}};
    throw std::invalid_argument("no sample shape of that name");
}

preprocess::ShapeSource source(std::string_view name, const ShapeBaking& baking) {
    if (name == "noise")
        return {noise(baking.width, baking.height), baking.width, baking.height, ""};
    outlines::Drawing shape = drawing(name);
    const int height = name == "letters"
                           ? static_cast<int>(std::lround(baking.width * shape.aspect))
                           : baking.height;
    return {std::move(shape), baking.width, height, ""};
}

std::string_view wrapName(WrapMode wrap) {
    return wrap == WrapMode::Repeat ? "repeat" : wrap == WrapMode::Mirror ? "mirror" : "clamp";
}

SolidPart extrusion(ShapePointer shape, Profile profile) {
    SolidPart part;
    part.solid.shape = std::move(shape);
    part.solid.profile = std::move(profile);
    return part;
}

SolidPart revolution(ShapePointer shape, double extension = 0.0) {
    SolidPart part;
    part.solid.shape = std::move(shape);
    part.solid.kind = SolidKind::Revolution;
    part.solid.extension = extension;
    return part;
}

// Sunk into a surface without an end.
SolidCase sunk(std::string name, SolidPart part, double depth = 0.3) {
    part.windowMinimum = {-kInfinity, -kInfinity, 0.0};
    part.windowMaximum = {kInfinity, kInfinity, 1.0};
    SolidCase result{std::move(name), {{part}}};
    result.low = part.windowMinimum;
    result.high = part.windowMaximum;
    result.depth = depth;
    return result;
}

SolidCase boxed(std::string name, std::vector<SolidPart> parts,
                const glm::dvec3& high = glm::dvec3(1.0), double depth = 0.6) {
    SolidCase result{std::move(name), {std::move(parts)}, true};
    result.high = high;
    result.depth = depth;
    return result;
}

// A part that fills tiles up to `high`.
SolidPart repeated(SolidPart part, const glm::dvec3& high) {
    part.windowMaximum = high;
    return part;
}

SolidPart joined(SolidPart part, BooleanOperation operation, const glm::dmat4& fromWhole) {
    part.operation = operation;
    part.fromWhole = fromWhole;
    return part;
}

// About the middle of the tile.
glm::dmat4 turned(double degrees, const glm::dvec3& axis) {
    const glm::dmat4 there = glm::translate(glm::dmat4(1.0), glm::dvec3(0.5));
    return glm::translate(glm::rotate(there, glm::radians(degrees), axis), glm::dvec3(-0.5));
}

struct NamedProfile {
    const char* name;
    Profile profile;
};

std::vector<NamedProfile> profiles() {
    const std::array<glm::dvec2, 6> steps{
        {{0.1, 0.0}, {0.3, 0.04}, {0.3, -0.02}, {0.6, -0.02}, {0.6, 0.05}, {0.9, 0.05}}};
    return {{"basic", makeProfile(0.0)},
            {"extended", makeProfile(0.03)},
            {"bevel", makeProfile(0.0, 0.05)},
            {"large bevel", makeProfile(-0.05, 0.4)},
            {"chamfer", makeProfile(0.0, 0.08, 0.3)},
            // The ray may pass a flat chamfer whose distance alone would let it go on (V' of 4.8).
            {"flat chamfer", makeProfile(0.0, 0.2, 0.02)},
            {"negative bevel", makeProfile(0.04, -0.06)},
            {"round", makeProfile(0.0, 0.07, 0.4, ProfileShape::Round)},
            {"cove", makeProfile(0.0, 0.07, 0.6, ProfileShape::Cove)},
            {"ogee", makeProfile(0.0, 0.08, 0.8, ProfileShape::Ogee)},
            {"steps", solids::profileThrough(steps)}};
}

}  // namespace

ShapePointer sampleShape(std::string_view name, const ShapeBaking& baking) {
    using Key = std::tuple<std::string, int, int, WrapMode, bool, StorageFormat>;
    static std::map<Key, ShapePointer> baked;
    ShapePointer& shape = baked[{std::string(name), baking.width, baking.height, baking.wrap,
                                 baking.isSigned, baking.format}];
    if (!shape) {
        preprocess::ShapePlan plan;
        plan.wrap = baking.wrap;
        plan.isSigned = baking.isSigned;
        plan.format = baking.format;
        plan.isWhiteInside = name == "noise";
        plan.width = baking.width;
        plan.height = baking.height;
        shape =
            std::make_shared<textures::ShapeMap>(preprocess::bakeShape(source(name, baking), plan));
    }
    return shape;
}

reference::PlaneOutline sampleOutline(std::string_view name) {
    std::vector<reference::OutlineContour> contours;
    outlines::FillRule rule = outlines::FillRule::NonZero;
    for (const outlines::Outline& shape : drawing(name).shapes) {
        contours.insert(contours.end(), shape.contours.begin(), shape.contours.end());
        rule = shape.rule;
    }
    return reference::PlaneOutline(contours, rule == outlines::FillRule::NonZero
                                                 ? reference::Filling::NonZero
                                                 : reference::Filling::EvenOdd);
}

std::vector<SolidCase> extrusionCases() {
    std::vector<SolidCase> cases;
    const ShapePointer star = sampleShape("star");
    const ShapePointer boxStar = sampleShape("star", {.wrap = WrapMode::Clamp});
    for (const NamedProfile& named : profiles()) {
        cases.push_back(sunk(fmt::format("star, {}", named.name), extrusion(star, named.profile)));
        cases.push_back(boxed(fmt::format("star in a box, {}", named.name),
                              {extrusion(boxStar, named.profile)}));
    }
    cases.push_back(boxed("star of 512², chamfer",
                          {extrusion(sampleShape("star", {.width = 512, .height = 512}),
                                     makeProfile(0.0, 0.08, 0.3))}));
    // Beyond corners (textures::kCornersEndTexels) from the start, and from some depth on.
    for (const auto& [name, profile] : {std::pair("extended", makeProfile(0.045)),
                                        std::pair("negative bevel", makeProfile(0.06, -0.08))})
        cases.push_back(sunk(fmt::format("letters of 160, {}", name),
                             extrusion(sampleShape("letters", {.width = 160}), profile)));
    SolidPart cut = extrusion(boxStar, makeProfile(0.0, 0.08, 0.9));
    cut.windowMinimum = {0.13, 0.4, 0.25};
    cut.windowMaximum = {0.77, 0.9, 0.7};
    cases.push_back(boxed("star cut off", {cut}));
    const Profile round = profiles()[7].profile;
    // Of an unsigned map, which is 0 all over the inside, the outline is best taken between texels.
    const Profile halfTexel = makeProfile(0.5 / 101.0, 0.04, 0.3);
    for (const char* shape : {"annulus", "comb", "letters", "noise"})
        for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
            for (const bool isSigned : {true, false}) {
                const ShapeBaking baking{
                    .width = 101, .height = 101, .wrap = wrap, .isSigned = isSigned};
                cases.push_back(
                    sunk(fmt::format("{}, {}, {}", shape, wrapName(wrap),
                                     isSigned ? "signed" : "unsigned"),
                         extrusion(sampleShape(shape, baking), isSigned ? round : halfTexel)));
            }
    for (const StorageFormat format : {StorageFormat::U8, StorageFormat::U16, StorageFormat::Half})
        cases.push_back(
            sunk(fmt::format("letters, {}, chamfer", textures::storageFormatName(format)),
                 extrusion(sampleShape("letters", {.width = 160, .format = format}),
                           makeProfile(0.0, 0.05, 0.3))));
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 16), std::pair(16, 1),
                                        std::pair(128, 2), std::pair(61, 37)})
        for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
            cases.push_back(sunk(
                fmt::format("noise {}×{}, {}", width, height, wrapName(wrap)),
                extrusion(sampleShape("noise", {.width = width, .height = height, .wrap = wrap}),
                          makeProfile(0.0, 0.1 / width))));
    // Between deep stars rays go on for a thousand tiles.
    for (const double depth : {1e-6, 1e3})
        cases.push_back(sunk(fmt::format("star {} deep, chamfer", depth),
                             extrusion(star, makeProfile(0.0, 0.08, 0.3)), depth));
    return cases;
}

std::vector<SolidCase> revolutionCases() {
    std::vector<SolidCase> cases;
    const ShapeBaking clamped{.wrap = WrapMode::Clamp};
    for (const char* section : {"cone", "torus", "sphere", "vase"})
        cases.push_back(
            boxed(section, {revolution(sampleShape(section, clamped))}, glm::dvec3(1.0), 1.0));
    cases.push_back(boxed(
        "vase, u8",
        {revolution(sampleShape(
            "vase",
            {.width = 101, .height = 101, .wrap = WrapMode::Clamp, .format = StorageFormat::U8}))},
        glm::dvec3(1.0), 1.0));
    cases.push_back(boxed("torus, extended", {revolution(sampleShape("torus", clamped), 0.04)}));
    cases.push_back(boxed("cone, smaller", {revolution(sampleShape("cone", clamped), -0.05)}));
    cases.push_back(boxed("cone, larger", {revolution(sampleShape("cone", clamped), 0.05)}));
    cases.push_back(
        boxed("torus of 1024²",
              {revolution(sampleShape("torus",
                                      {.width = 1024, .height = 1024, .wrap = WrapMode::Clamp}))}));
    SolidPart offCentre = revolution(sampleShape("vase", clamped));
    offCentre.solid.axis = {0.3, 0.85};
    cases.push_back(boxed("vase, off-centre", {offCentre}));
    const glm::dvec3 many(10.0, 10.0, 1.0);
    cases.push_back(
        boxed("10×10 vases", {repeated(revolution(sampleShape("vase")), many)}, many, 1.0));
    const glm::dvec3 pile(2.0, 2.0, 10.0);
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror})
        cases.push_back(boxed(fmt::format("cones on cones, {}", wrapName(wrap)),
                              {repeated(revolution(sampleShape("cone", {.wrap = wrap})), pile)},
                              pile, 1.0));
    cases.push_back(sunk("vases", revolution(sampleShape("vase"))));
    cases.push_back(
        sunk("noise revolved", revolution(sampleShape("noise", {.width = 37, .height = 23})), 0.6));
    return cases;
}

std::vector<SolidCase> compoundCases() {
    const ShapeBaking clamped{.wrap = WrapMode::Clamp};
    const ShapePointer star = sampleShape("star", clamped);
    const ShapePointer disc = sampleShape("disc", clamped);
    const SolidPart roundStar = extrusion(star, makeProfile(0.0, 0.06, 0.3, ProfileShape::Round));
    const SolidPart drum = extrusion(disc, makeProfile(0.0, 0.05, 0.2));
    const SolidPart ring = revolution(sampleShape("torus", clamped));
    const SolidPart ball = revolution(sampleShape("sphere", clamped));
    const glm::dmat4 upright = turned(90.0, {1.0, 0.0, 0.0});
    const glm::dmat4 askew = turned(37.0, {1.0, 2.0, 3.0});
    std::vector<SolidCase> cases;
    cases.push_back(boxed("star and star across",
                          {roundStar, joined(roundStar, BooleanOperation::Union, upright)}));
    cases.push_back(boxed("star with star askew",
                          {roundStar, joined(roundStar, BooleanOperation::Intersection, askew)}));
    cases.push_back(boxed("drum less star askew",
                          {drum, joined(roundStar, BooleanOperation::Difference, askew)}));
    cases.push_back(
        boxed("drum less ring askew", {drum, joined(ring, BooleanOperation::Difference, askew)}));
    cases.push_back(boxed("star across with ball",
                          {joined(roundStar, BooleanOperation::Union, upright),
                           joined(ball, BooleanOperation::Intersection, glm::dmat4(1.0))}));
    // What is taken away repeats, or is 0 all over its inside.
    const glm::dmat4 manifold = glm::scale(glm::dmat4(1.0), glm::dvec3(4.0, 4.0, 2.0));
    cases.push_back(
        boxed("drum less 4×4×2 vases",
              {drum, joined(repeated(revolution(sampleShape("vase", {.wrap = WrapMode::Mirror})),
                                     glm::dvec3(4.0, 4.0, 2.0)),
                            BooleanOperation::Difference, manifold)}));
    cases.push_back(boxed(
        "star less 4×4 letters",
        {roundStar,
         joined(repeated(extrusion(sampleShape("letters", {.width = 96, .wrap = WrapMode::Mirror}),
                                   makeProfile(0.0, 0.05, 0.8)),
                         glm::dvec3(4.0, 4.0, 1.0)),
                BooleanOperation::Difference,
                glm::scale(glm::dmat4(1.0), glm::dvec3(4.0, 4.0, 1.0)))}));
    cases.push_back(boxed(
        "drum less unsigned star",
        {drum, joined(extrusion(sampleShape("star", {.wrap = WrapMode::Clamp, .isSigned = false}),
                                makeProfile(0.0)),
                      BooleanOperation::Difference, glm::dmat4(1.0))}));
    cases.push_back(boxed(
        "drum less unsigned vase",
        {drum, joined(revolution(sampleShape("vase", {.wrap = WrapMode::Clamp, .isSigned = false})),
                      BooleanOperation::Difference, turned(20.0, {0.0, 1.0, 0.0}))}));
    // The star twice as small, in a corner.
    const glm::dmat4 doubled =
        glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(-0.5)), glm::dvec3(2.0));
    cases.push_back(boxed("ball with drum less ring, and star",
                          {ball, joined(drum, BooleanOperation::Intersection, upright),
                           joined(ring, BooleanOperation::Difference, askew),
                           joined(roundStar, BooleanOperation::Union, doubled)}));
    cases.push_back(boxed("ball less drum less ring less star",
                          {ball, joined(drum, BooleanOperation::Difference, upright),
                           joined(ring, BooleanOperation::Difference, glm::dmat4(1.0)),
                           joined(roundStar, BooleanOperation::Difference, askew)}));
    return cases;
}

}  // namespace relievo::viewer

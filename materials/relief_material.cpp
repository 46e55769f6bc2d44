#include "materials/relief_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "gl/context.h"
#include "textures/input_error.h"

namespace relievo::materials {
namespace {

// The location of a uniform that the shader library declares: without it the picture would be wrong
// in silence, so its absence is an error.
GLint uniformLocation(GLuint program, std::string_view name) {
    const GLint location = glGetUniformLocation(program, std::string(name).c_str());
    if (location < 0)
        throw gl::GlError(
            fmt::format("the program has no uniform {}: it must include the technique's file and "
                        "relievo/material.glsl, and use what traceRelief returns",
                        name));
    return location;
}

}  // namespace

ReliefMaterial::ReliefMaterial(std::shared_ptr<ReliefMaps> maps, const Technique& technique)
    : maps_(std::move(maps)), technique_(&technique), slopes_(bestSlopeSource(*maps_)) {
    for (const std::string_view map : technique.maps) {
        maps_->require(map);
        static_cast<void>(maps_->number(map));
    }
    setSlopeSource(slopes_);
    for (const TechniqueParameter& parameter : technique.parameters)
        values_.push_back(parameter.defaultValue);
}

ReliefMaterial ReliefMaterial::shownBy(const Technique& technique) const {
    ReliefMaterial other(maps_, technique);
    other.depthScale = depthScale;
    other.window = window;
    other.levels = levels;
    other.slopes_ = slopes_;
    return other;
}

void ReliefMaterial::setParameter(std::string_view name, double value) {
    const TechniqueParameter& info = findParameter(*technique_, name);
    const bool whole = std::nearbyint(value) == value;
    if (!(value >= info.minimum && value <= info.maximum) || (info.isInteger && !whole))
        throw textures::InputError(fmt::format(
            "{} {}: {} is not {} from {} to {}", technique_->name, name, value,
            info.isInteger ? "a whole number" : "a number", info.minimum, info.maximum));
    values_[static_cast<std::size_t>(&info - technique_->parameters.data())] = value;
}

double ReliefMaterial::parameter(std::string_view name) const {
    const TechniqueParameter& info = findParameter(*technique_, name);
    return values_[static_cast<std::size_t>(&info - technique_->parameters.data())];
}

void ReliefMaterial::setSlopeSource(SlopeSource source) {
    const std::string_view map = slopeSourceEntry(source).map;
    if (!map.empty()) {
        maps_->require(map);
        static_cast<void>(maps_->number(map));
    }
    slopes_ = source;
}

bool ReliefMaterial::reads(std::string_view mapName) const {
    return std::ranges::find(technique_->maps, mapName) != technique_->maps.end();
}

std::vector<shaders::Define> ReliefMaterial::defines() const {
    const textures::MapSet& maps = maps_->maps();
    std::vector<shaders::Define> result;
    if (reads("cone") || reads("relaxed-cone")) {
        // What says nothing of a guarantee is taken to hold at texel centres only.
        const auto guarantee = maps.attributes.find("relievo:guarantee");
        if (guarantee != maps.attributes.end() && guarantee->second == "bilinear")
            result.push_back({"RELIEVO_CONE_BILINEAR", "1"});
        if (maps.encoding == textures::ConeEncoding::Radius)
            result.push_back({"RELIEVO_CONE_RADIUS", "1"});
    }
    if (const SlopeSourceEntry& slopes = slopeSourceEntry(slopes_); !slopes.define.empty())
        result.push_back({std::string(slopes.define), "1"});
    // Mirrored tiles have mirrored slopes, and beyond clamped ones there are none, whatever the
    // search.
    if (maps.wrap == textures::WrapMode::Mirror)
        result.push_back({"RELIEVO_WRAP_MIRROR", "1"});
    if (maps.wrap == textures::WrapMode::Clamp)
        result.push_back({"RELIEVO_WRAP_CLAMP", "1"});
    if (maps_->levelCount() > 1)
        result.push_back({"RELIEVO_MIPS", "1"});
    return result;
}

GLuint ReliefMaterial::bind(GLuint program, GLuint firstUnit) const {
    GLuint unit = firstUnit;
    const auto setNumber = [&](std::string_view uniform, bool isInteger, double value) {
        const GLint location = uniformLocation(program, uniform);
        if (isInteger)
            glProgramUniform1i(program, location, static_cast<GLint>(value));
        else
            glProgramUniform1f(program, location, static_cast<GLfloat>(value));
    };
    const auto bindMap = [&](std::string_view name) {
        const ReliefMapFormat& format = reliefMapFormat(name);
        setNumber(format.sampler, true, unit);
        maps_->texture(name).bind(unit++);
        if (!format.number.attribute.empty())
            setNumber(format.number.uniform, format.number.isInteger, maps_->number(name));
    };
    for (const std::string_view map : technique_->maps)
        bindMap(map);
    if (const std::string_view map = slopeSourceEntry(slopes_).map; !map.empty())
        bindMap(map);

    for (std::size_t k = 0; k < values_.size(); ++k) {
        const TechniqueParameter& info = technique_->parameters[k];
        setNumber(info.uniform, info.isInteger, values_[k]);
    }
    // Only techniques that know how deep the relief is have this one.
    const GLint depthRange = glGetUniformLocation(program, "relievoDepthRange");
    if (depthRange >= 0)
        glProgramUniform2fv(program, depthRange, 1, glm::value_ptr(maps_->depthRange()));
    setNumber("relievoDepthScale", false, static_cast<double>(depthScale));
    glProgramUniform4fv(program, uniformLocation(program, "relievoWindow"), 1,
                        glm::value_ptr(window));
    if (maps_->levelCount() > 1) {
        const glm::vec2 range =
            glm::min(levels, glm::vec2(static_cast<float>(maps_->levelCount() - 1)));
        glProgramUniform2fv(program, uniformLocation(program, "relievoLevels"), 1,
                            glm::value_ptr(range));
    }
    return unit;
}

}  // namespace relievo::materials

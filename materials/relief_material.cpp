#include "materials/relief_material.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>

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

// Throws textures::InputError when one is missing, or the number that belongs to it is wrong.
void requireMaps(const ReliefMaps& maps, std::span<const std::string_view> names) {
    for (const std::string_view name : names) {
        maps.require(name);
        static_cast<void>(maps.number(name));
    }
}

}  // namespace

ReliefMaterial::ReliefMaterial(std::shared_ptr<ReliefMaps> maps, const Technique& technique)
    : maps_(std::move(maps)), technique_(&technique), slopes_(bestSlopeSource(*maps_)) {
    requireMaps(*maps_, technique.maps);
    setSlopeSource(slopes_);
    addParameters(technique.parameters);
}

void ReliefMaterial::addParameters(std::span<const TechniqueParameter> parameters) {
    for (const TechniqueParameter& parameter : parameters)
        values_.push_back({&parameter, parameter.defaultValue});
}

void ReliefMaterial::setShadow(const ShadowMethod* method) {
    if (method && method->searches && !technique_->isSearch)
        throw textures::InputError(
            fmt::format("{} does not search, so that it cannot follow light rays for the shadow "
                        "method \"{}\"; expected another technique or another method",
                        technique_->title, method->name));
    if (method)
        requireMaps(*maps_, method->maps);
    shadow_ = method;
    values_.erase(values_.begin() + std::ssize(technique_->parameters), values_.end());
    if (method)
        addParameters(method->parameters);
}

const ReliefMaterial::ParameterValue& ReliefMaterial::find(std::string_view parameterName) const {
    const auto nameOf = [](const ParameterValue& value) { return value.info->name; };
    const auto found = std::ranges::find(values_, parameterName, nameOf);
    if (found != values_.end())
        return *found;
    std::vector<std::string_view> names;
    std::ranges::transform(values_, std::back_inserter(names), nameOf);
    throw textures::InputError(fmt::format(
        "technique {} has no parameter \"{}\", it has {}", technique_->name, parameterName,
        names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

ReliefMaterial ReliefMaterial::shownBy(const Technique& technique) const {
    ReliefMaterial other(maps_, technique);
    other.depthScale = depthScale;
    other.window = window;
    other.levels = levels;
    other.pixelRays = pixelRays;
    other.slopes_ = slopes_;
    other.setShadow(shadow_);
    for (ParameterValue& value : other.values_)
        for (const ParameterValue& known : values_)
            if (known.info->uniform == value.info->uniform)
                value.value = known.value;
    return other;
}

void ReliefMaterial::setParameter(std::string_view name, double value) {
    const ParameterValue& parameter = find(name);
    requireInRange(*technique_, *parameter.info, value);
    values_[static_cast<std::size_t>(&parameter - values_.data())].value = value;
}

double ReliefMaterial::parameter(std::string_view name) const {
    return find(name).value;
}

std::vector<std::string_view> ReliefMaterial::files() const {
    std::vector<std::string_view> result = {technique_->file};
    if (shadow_)
        result.push_back(shadow_->file);
    return result;
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

std::vector<std::string_view> ReliefMaterial::mapNames() const {
    std::vector<std::string_view> names(technique_->maps.begin(), technique_->maps.end());
    const auto add = [&](std::string_view name) {
        if (std::ranges::find(names, name) == names.end())
            names.push_back(name);
    };
    if (const std::string_view slopes = slopeSourceEntry(slopes_).map; !slopes.empty())
        add(slopes);
    if (shadow_)
        std::ranges::for_each(shadow_->maps, add);
    return names;
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
        if (const int sectors = maps_->coneSectors(); sectors > 1)
            result.push_back({"RELIEVO_CONE_SECTORS", std::to_string(sectors)});
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
    if (shadow_)
        result.push_back({"RELIEVO_SHADOW", "1"});
    if (pixelRays > 1)
        result.push_back({"RELIEVO_PIXEL_RAYS", "1"});
    return result;
}

GLuint ReliefMaterial::bind(GLuint program, GLuint firstUnit) const {
    return bindFor(Use::Shading, program, firstUnit);
}

GLuint ReliefMaterial::bindSearch(GLuint program, GLuint firstUnit) const {
    return bindFor(Use::Search, program, firstUnit);
}

GLuint ReliefMaterial::bindFor(Use use, GLuint program, GLuint firstUnit) const {
    GLuint unit = firstUnit;
    // OpenGL ignores what is set at the location −1.
    const auto locate = [&](std::string_view uniform) {
        return use == Use::Shading ? uniformLocation(program, uniform)
                                   : glGetUniformLocation(program, std::string(uniform).c_str());
    };
    const auto setNumber = [&](std::string_view uniform, bool isInteger, double value) {
        const GLint location = locate(uniform);
        if (isInteger)
            glProgramUniform1i(program, location, static_cast<GLint>(value));
        else
            glProgramUniform1f(program, location, static_cast<GLfloat>(value));
    };
    const auto bindMap = [&](std::string_view name) {
        const ReliefMapFormat& format = reliefMapFormat(name);
        if (use == Use::Search && locate(format.sampler) < 0)
            return;  // nothing is uploaded for it
        setNumber(format.sampler, true, unit);
        maps_->texture(name).bind(unit++);
        if (!format.number.attribute.empty())
            setNumber(format.number.uniform, format.number.isInteger, maps_->number(name));
    };
    for (const std::string_view map : mapNames())
        bindMap(map);
    for (const ParameterValue& parameter : values_)
        setNumber(parameter.info->uniform, parameter.info->isInteger, parameter.value);
    // Only techniques that know how deep the relief is have this one.
    const GLint depthRange = glGetUniformLocation(program, "relievoDepthRange");
    if (depthRange >= 0)
        glProgramUniform2fv(program, depthRange, 1, glm::value_ptr(maps_->depthRange()));
    setNumber("relievoDepthScale", false, static_cast<double>(depthScale));
    glProgramUniform4fv(program, locate("relievoWindow"), 1, glm::value_ptr(window));
    if (maps_->levelCount() > 1) {
        const glm::vec2 range =
            glm::min(levels, glm::vec2(static_cast<float>(maps_->levelCount() - 1)));
        glProgramUniform2fv(program, locate("relievoLevels"), 1, glm::value_ptr(range));
        // A program that looks at one normal a pixel has no use for it, and nothing is made for it.
        const ReliefMapFormat& moments = reliefMapFormat("slope-moments");
        if (glGetUniformLocation(program, std::string(moments.sampler).c_str()) >= 0)
            bindMap(moments.name);
    }
    // A program that takes one ray a pixel, to measure it or for want of more, has none.
    const GLint rays = glGetUniformLocation(program, "relievoPixelRays");
    if (rays >= 0)
        glProgramUniform1i(program, rays, pixelRays);
    return unit;
}

}  // namespace relievo::materials

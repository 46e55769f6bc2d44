#include "materials/solid_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <iterator>
#include <string>

#include "shaders/relievo/constants.h"
#include "textures/input_error.h"

namespace relievo::materials {

SolidMaterial::SolidMaterial(std::shared_ptr<ShapeTextureCache> shapes, solids::Compound parts,
                             const SolidTechnique& technique)
    : compound(std::move(parts)), shapes_(std::move(shapes)), technique_(&technique) {
    requireShown(technique, compound);
    for (const solids::SolidPart& part : compound.parts)
        if (!part.solid.shape)
            throw textures::InputError("a part of a solid has no shape");
    looks.resize(compound.parts.size());
    static_cast<void>(solidBlock(compound, looks));
    for (const TechniqueParameter& parameter : technique.technique.parameters)
        values_.push_back(parameter.defaultValue);
}

const TechniqueParameter& SolidMaterial::find(std::string_view name, std::size_t& place) const {
    const TechniqueParameter& parameter = findParameter(technique_->technique, name);
    place = static_cast<std::size_t>(&parameter - technique_->technique.parameters.data());
    return parameter;
}

void SolidMaterial::setParameter(std::string_view name, double value) {
    std::size_t place = 0;
    requireInRange(technique_->technique, find(name, place), value);
    values_[place] = value;
}

double SolidMaterial::parameter(std::string_view name) const {
    std::size_t place = 0;
    static_cast<void>(find(name, place));
    return values_[place];
}

std::vector<std::string_view> SolidMaterial::searchFiles() const {
    return {technique_->technique.file};
}

std::vector<std::string_view> SolidMaterial::files() const {
    std::vector<std::string_view> result = searchFiles();
    if (relief)
        result.push_back(relief->technique().file);
    return result;
}

bool SolidMaterial::isCreased() const {
    return technique_->capabilities.creases &&
           std::ranges::any_of(compound.parts, [](const solids::SolidPart& part) {
               return part.solid.shape->isCreased();
           });
}

std::vector<shaders::Define> SolidMaterial::defines() const {
    std::vector<shaders::Define> result{
        {"RELIEVO_SOLID", "1"}, {"RELIEVO_SOLID_PARTS", std::to_string(compound.parts.size())}};
    for (std::size_t k = 0; k < compound.parts.size(); ++k) {
        const bool isRevolution = compound.parts[k].solid.kind == solids::SolidKind::Revolution;
        result.push_back(
            {fmt::format("RELIEVO_SOLID_KIND{}", k),
             std::to_string(isRevolution ? RELIEVO_SOLID_REVOLUTION : RELIEVO_SOLID_EXTRUSION)});
    }
    if (isCreased())
        result.push_back({"RELIEVO_SOLID_CREASED", "1"});
    if (isInBox())
        result.push_back({"RELIEVO_SHAPE_BOX", "1"});
    if (shadowsItself)
        result.push_back({"RELIEVO_SOLID_SHADOW", "1"});
    if (relief) {
        result.push_back({"RELIEVO_SOLID_RELIEF", "1"});
        std::ranges::move(relief->defines(), std::back_inserter(result));
    }
    return result;
}

GLuint SolidMaterial::bind(GLuint program, GLuint firstUnit) const {
    const GLuint unit = bindSearch(program, firstUnit);
    glProgramUniform2fv(program, glGetUniformLocation(program, "relievoSolidPictureTiles"), 1,
                        glm::value_ptr(pictureTiles));
    return relief ? relief->bind(program, unit) : unit;
}

GLuint SolidMaterial::bindSearch(GLuint program, GLuint firstUnit) const {
    requireShown(*technique_, compound);  // it may have been edited
    GLuint unit = firstUnit;
    // OpenGL ignores what is set at the location −1.
    const auto locate = [program](const std::string& uniform) {
        return glGetUniformLocation(program, uniform.c_str());
    };
    const auto bindTexture = [&](const std::string& sampler, const gl::Texture& texture) {
        glProgramUniform1i(program, locate(sampler), static_cast<GLint>(unit));
        texture.bind(unit++);
    };
    for (std::size_t k = 0; k < compound.parts.size(); ++k) {
        const solids::Solid& solid = compound.parts[k].solid;
        const ShapeTextures& shape =
            shapes_->get(solid.shape, solid.kind == solids::SolidKind::Revolution,
                         technique_->capabilities.creases);
        bindTexture(fmt::format("relievoSolidDistances{}", k), shape.distances);
        bindTexture(fmt::format("relievoSolidGradients{}", k), shape.gradients);
    }
    std::vector<std::byte> bytes = solidBlock(compound, looks);
    if (bytes != bytes_) {
        buffer_ = gl::Buffer(bytes);
        bytes_ = std::move(bytes);
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, RELIEVO_BLOCK_SOLID, buffer_.id());
    const GLuint block = glGetUniformBlockIndex(program, "RelievoSolid");
    if (block != GL_INVALID_INDEX)
        glUniformBlockBinding(program, block, RELIEVO_BLOCK_SOLID);
    for (std::size_t k = 0; k < values_.size(); ++k) {
        const TechniqueParameter& parameter = technique_->technique.parameters[k];
        const GLint location = locate(std::string(parameter.uniform));
        if (parameter.isInteger)
            glProgramUniform1i(program, location, static_cast<GLint>(values_[k]));
        else
            glProgramUniform1f(program, location, static_cast<GLfloat>(values_[k]));
    }
    glProgramUniform3fv(program, locate("relievoSolidLow"), 1, glm::value_ptr(glm::vec3(low)));
    glProgramUniform3fv(program, locate("relievoSolidHigh"), 1, glm::value_ptr(glm::vec3(high)));
    glProgramUniform1f(program, locate("relievoSolidDepth"), depthScale);
    glProgramUniform1i(program, locate("relievoSolidFloor"), hasFloor ? 1 : 0);
    if (boxFromWhole) {
        const glm::mat4 fromWorld(glm::inverse(*boxFromWhole));
        glProgramUniformMatrix4fv(program, locate("relievoSolidFromWorld"), 1, GL_FALSE,
                                  glm::value_ptr(fromWorld));
    }
    return unit;
}

}  // namespace relievo::materials

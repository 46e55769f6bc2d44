#pragma once

#include <string>

#include "gl/framebuffer.h"
#include "gl/program.h"

namespace relievo::gl::tests {

/// A program that runs `fragment` for every pixel. `in vec2 uv` of it is (0,0) at the top left
/// corner of the picture and (1,1) at the bottom right one.
Program fullScreenProgram(const std::string& fragment);

/// Draws the program over all of the framebuffer.
void drawFullScreen(const Program& program, const Framebuffer& target);

}  // namespace relievo::gl::tests

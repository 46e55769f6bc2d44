#include "full_screen_pass.h"

#include "gl/buffer.h"

namespace relievo::gl::tests {
namespace {

constexpr const char* kVertexText = R"(#version 450 core
out vec2 uv;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    uv = corner;
    gl_Position = vec4(2.0 * corner.x - 1.0, 1.0 - 2.0 * corner.y, 0.0, 1.0);
}
)";

}  // namespace

Program fullScreenProgram(const std::string& fragment) {
    return Program({{GL_VERTEX_SHADER, kVertexText, {"full_screen.vert"}},
                    {GL_FRAGMENT_SHADER, fragment, {"test.frag"}}});
}

void drawFullScreen(const Program& program, const Framebuffer& target) {
    const VertexArray noAttributes;
    target.bind();
    program.use();
    noAttributes.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace relievo::gl::tests

#include "gl/occlusion_query.h"

namespace relievo::gl {
namespace {

GLuint createQuery() {
    GLuint id = 0;
    glCreateQueries(GL_ANY_SAMPLES_PASSED, 1, &id);
    return id;
}

}  // namespace

void deleteQuery(GLuint id) noexcept {
    glDeleteQueries(1, &id);
}

OcclusionQuery::OcclusionQuery() : name_(createQuery()) {}

void OcclusionQuery::begin() const {
    glBeginQuery(GL_ANY_SAMPLES_PASSED, name_.id());
}

void OcclusionQuery::end() {
    glEndQuery(GL_ANY_SAMPLES_PASSED);
}

void OcclusionQuery::beginConditional() const {
    glBeginConditionalRender(name_.id(), GL_QUERY_WAIT);
}

void OcclusionQuery::endConditional() {
    glEndConditionalRender();
}

}  // namespace relievo::gl

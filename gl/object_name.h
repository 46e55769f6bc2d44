#pragma once

#include <glad/gl.h>

#include <utility>

namespace relievo::gl {

/// Owns the name of one OpenGL object and deletes it with `destroy`. Move only; what was moved from
/// holds 0, which owns nothing. The context in which the object was made must be current when it is
/// destroyed or assigned to.
template <void (*destroy)(GLuint) noexcept>
class ObjectName {
  public:
    ObjectName() = default;
    explicit ObjectName(GLuint id) noexcept : id_(id) {}
    ~ObjectName() {
        if (id_ != 0)
            destroy(id_);
    }
    ObjectName(ObjectName&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    ObjectName& operator=(ObjectName&& other) noexcept {
        // Through a temporary, so that the old object goes now and moving to itself changes
        // nothing.
        ObjectName moved(std::move(other));
        std::swap(id_, moved.id_);
        return *this;
    }

    [[nodiscard]] GLuint id() const noexcept { return id_; }

  private:
    GLuint id_ = 0;
};

}  // namespace relievo::gl

#pragma once

#include <glad/gl.h>

#include "gl/object_name.h"

namespace relievo::gl {

void deleteQuery(GLuint id) noexcept;

/// Asks whether anything of a draw passes the depth test, and leaves out later draws when nothing
/// did. Move only. Its context must be current whenever it is used, and when it is destroyed.
class OcclusionQuery {
  public:
    OcclusionQuery();

    /// Asks about all draws between the two.
    void begin() const;
    static void end();
    /// Leaves out all draws between the two if nothing of what was asked about passed. The graphics
    /// processor waits for the answer, the program does not.
    void beginConditional() const;
    static void endConditional();

  private:
    ObjectName<deleteQuery> name_;
};

}  // namespace relievo::gl

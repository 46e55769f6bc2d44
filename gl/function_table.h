#pragma once

#include <glad/gl.h>

namespace relievo::gl {

/// Points the gl… functions of the process at one OpenGL library: `lookup` finds a function of the
/// current context by its name. Does nothing when they already point there. The table is one for
/// the whole process: contexts of one back end may be used on several threads at a time, contexts
/// of different back ends, or with and without debug, only in turn.
///
/// With `debug`, every call goes through a wrapper that throws GlError after a call about which
/// watchDriverMessages heard of an error. Without, the pointers lead straight to the driver.
///
/// Throws GlError when the library offers less than OpenGL 4.5.
void pointFunctionsAt(GLADloadfunc lookup, bool debug);

/// Has the current context report its errors, at the call that caused them, to this thread.
void watchDriverMessages();

}  // namespace relievo::gl

#pragma once

#include <string>

#include "textures/plane.h"

namespace relievo::textures {

/// 16 hexadecimal digits that stand for the size and the samples of `plane`, the same on every
/// machine and in every version: the content of `relievo:source`.
std::string contentHash(const Plane& plane);

}  // namespace relievo::textures

#pragma once

#include "preprocess/verify_input.h"

namespace relievo::preprocess {

/// Whether `file` is a shape map.
bool isShapeFile(const std::string& file);

/// Checks that no step by the distances of a shape map enters its solid, and that its channels
/// agree, and prints what it found. Throws InputError when they do not, after printing, or when the
/// file is damaged, and UsageError for options that are for cones.
void verifyShape(const VerifyArguments& arguments);

}  // namespace relievo::preprocess

#pragma once

#include <string>
#include <vector>

#include "tests/commands/process.h"

namespace relievo::preprocess {

/// Runs the relievo-bake that was built with the tests.
inline tests::ProcessResult bake(std::vector<std::string> arguments,
                                 const tests::ProcessOptions& options = {}) {
    arguments.insert(arguments.begin(), RELIEVO_BAKE);
    return tests::runProcess(arguments, options);
}

}  // namespace relievo::preprocess

#pragma once

#include <stdexcept>
#include <string>

namespace relievo::textures {

/// What is wrong with an input that the user gave: one sentence that names the file, what is wrong
/// with it and what was expected. Commands print it and exit with status 1.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace relievo::textures

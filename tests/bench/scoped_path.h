#pragma once

#include <cstdlib>
#include <string>

namespace relievo::tests {

/// Where programs are looked for (PATH), for as long as the object lives.
class ScopedPath {
  public:
    explicit ScopedPath(const std::string& path) : previous_(std::getenv("PATH")) {
        ::setenv("PATH", path.c_str(), 1);
    }
    ~ScopedPath() { ::setenv("PATH", previous_.c_str(), 1); }
    ScopedPath(const ScopedPath&) = delete;
    ScopedPath& operator=(const ScopedPath&) = delete;

  private:
    std::string previous_;
};

}  // namespace relievo::tests

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relievo::gl {

/// Rewrites the log of a GLSL compiler so that each message reads `file:line: text`, where a
/// message on source K is one on files[K]. Understands the forms `K:line(column): text` (Mesa),
/// `K(line) : text` (NVIDIA) and `ERROR: K:line: text` (others); keeps lines of any other form, and
/// messages on a source that `files` lacks, as they are. Drops empty lines.
std::string locateMessages(std::string_view log, const std::vector<std::string>& files);

}  // namespace relievo::gl

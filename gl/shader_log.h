#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::gl {

/// A line of a source file: files[file], counted from 1.
struct SourceLine {
    std::size_t file = 0;
    std::int64_t line = 1;

    friend bool operator==(const SourceLine&, const SourceLine&) = default;
};

/// A shader's text without `#line` directives, each of which is now an empty line, and where each
/// of its lines came from.
struct TracedText {
    std::string text;
    std::vector<SourceLine> lines;
};

/// Resolves `#line N K` (the next line is line N of source K) and `#line N` (of the same source).
/// Drivers cannot be trusted with them: Mesa 22.3 reports source 0 for every error in an
/// expression.
TracedText traceLines(std::string_view text);

/// Rewrites the log of a GLSL compiler so that each message on a line of the text reads
/// `file:line: message`. Understands the forms `0:line(column): message` (Mesa),
/// `0(line) : message` (NVIDIA) and `ERROR: 0:line: message` (others); keeps lines of any other
/// form, and messages on lines or files that are not listed, as they are. Drops empty lines.
std::string locateMessages(std::string_view log, const std::vector<SourceLine>& lines,
                           const std::vector<std::string>& files);

}  // namespace relievo::gl

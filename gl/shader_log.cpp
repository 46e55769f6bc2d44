#include "gl/shader_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <sstream>

namespace relievo::gl {
namespace {

/// What is still to be read of a line.
struct Cursor {
    std::string_view rest;

    bool skip(std::string_view word) {
        if (!rest.starts_with(word))
            return false;
        rest.remove_prefix(word.size());
        return true;
    }

    bool skipBlanks() {
        const std::size_t count = std::min(rest.find_first_not_of(" \t\r"), rest.size());
        rest.remove_prefix(count);
        return count > 0;
    }

    /// A number without a sign; the largest int for one that is too large, which no line or file
    /// has.
    std::optional<int> number() {
        const std::size_t count = std::min(rest.find_first_not_of("0123456789"), rest.size());
        if (count == 0)
            return std::nullopt;
        int value = std::numeric_limits<int>::max();
        std::from_chars(rest.data(), rest.data() + count, value);
        rest.remove_prefix(count);
        return value;
    }
};

/// What `#line` says of the line after it: its number, and its source if that is named.
struct LineDirective {
    int line;
    std::optional<int> source;
};

std::optional<LineDirective> parseLineDirective(std::string_view text) {
    Cursor cursor{text};
    cursor.skipBlanks();
    if (!cursor.skip("#"))
        return std::nullopt;
    cursor.skipBlanks();
    if (!cursor.skip("line") || !cursor.skipBlanks())
        return std::nullopt;
    const std::optional<int> line = cursor.number();
    cursor.skipBlanks();
    const std::optional<int> source = cursor.number();
    cursor.skipBlanks();
    if (!line || !(cursor.rest.empty() || cursor.rest.starts_with("//")))
        return std::nullopt;
    return LineDirective{*line, source};
}

/// The line that a message is on, after its source: `:line(column):`, `:line:` or `(line) :`.
std::optional<int> parsePlace(Cursor& cursor) {
    std::optional<int> line;
    if (cursor.skip(":")) {
        line = cursor.number();
        if (cursor.skip("(") && !(cursor.number() && cursor.skip(")")))
            return std::nullopt;
    } else if (cursor.skip("(")) {
        line = cursor.number();
        if (!cursor.skip(")"))
            return std::nullopt;
    }
    cursor.skipBlanks();
    return cursor.skip(":") ? line : std::nullopt;
}

std::string locateMessage(std::string_view message, const std::vector<SourceLine>& lines,
                          const std::vector<std::string>& files) {
    Cursor cursor{message};
    std::string_view severity;
    for (const std::string_view word : {"ERROR: ", "WARNING: "})
        if (cursor.skip(word))
            severity = word;
    // The text is given to the driver as one string, whose number is 0.
    if (cursor.number() != 0)
        return std::string(message);
    const std::optional<int> line = parsePlace(cursor);
    if (!line || *line < 1 || static_cast<std::size_t>(*line) > lines.size())
        return std::string(message);
    const SourceLine& source = lines[*line - 1];
    if (source.file >= files.size())
        return std::string(message);
    cursor.skipBlanks();
    return fmt::format("{}:{}: {}{}", files[source.file], source.line, severity, cursor.rest);
}

}  // namespace

TracedText traceLines(std::string_view text) {
    TracedText traced;
    SourceLine next;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        traced.lines.push_back(next);
        ++next.line;
        if (const auto directive = parseLineDirective(line)) {
            next.line = directive->line;
            if (directive->source)
                next.file = static_cast<std::size_t>(*directive->source);
            line.clear();
        }
        traced.text += line;
        traced.text += '\n';
    }
    traced.lines.push_back(next);  // drivers place some errors on the line after the last
    return traced;
}

std::string locateMessages(std::string_view log, const std::vector<SourceLine>& lines,
                           const std::vector<std::string>& files) {
    std::istringstream messages{std::string(log)};
    std::string located;
    for (std::string message; std::getline(messages, message);) {
        message.resize(message.find_last_not_of(std::string_view(" \r\0", 3)) + 1);
        if (message.empty())
            continue;
        if (!located.empty())
            located += '\n';
        located += locateMessage(message, lines, files);
    }
    return located;
}

}  // namespace relievo::gl

#include "gl/shader_log.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <regex>
#include <sstream>

namespace relievo::gl {
namespace {

/// The number, or the largest int for one that is too large: no line or file has it.
int numberOf(const std::string& digits) {
    int number = std::numeric_limits<int>::max();
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

std::string locateMessage(const std::string& message, const std::vector<SourceLine>& lines,
                          const std::vector<std::string>& files) {
    // 1: "ERROR: " and the like; 2 or 3: line; 4: text.
    static const std::regex form(
        R"(^((?:ERROR|WARNING): )?0(?::(\d+)(?:\(\d+\))?|\((\d+)\)) ?: ?(.*)$)");
    std::smatch match;
    if (!std::regex_match(message, match, form))
        return message;
    const int line = numberOf(match[2].str() + match[3].str());
    if (line < 1 || static_cast<std::size_t>(line) > lines.size())
        return message;
    const SourceLine& source = lines[line - 1];
    if (source.file >= files.size())
        return message;
    return fmt::format("{}:{}: {}{}", files[source.file], source.line, match[1].str(),
                       match[4].str());
}

}  // namespace

TracedText traceLines(std::string_view text) {
    static const std::regex directive(R"(^\s*#\s*line\s+(\d+)(?:\s+(\d+))?\s*(?://.*)?$)");
    TracedText traced;
    SourceLine next;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        traced.lines.push_back(next);
        ++next.line;
        std::smatch match;
        if (std::regex_match(line, match, directive)) {
            next.line = numberOf(match[1]);
            if (match[2].matched)
                next.file = static_cast<std::size_t>(numberOf(match[2]));
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

#include "gl/shader_log.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <regex>
#include <sstream>

namespace relievo::gl {
namespace {

/// One message, of any of the three forms, in terms of a source file; otherwise as it is.
std::string locateMessage(const std::string& message, const std::vector<std::string>& files) {
    // 1: "ERROR: " and the like; 2: source; 3 or 4: line; 5: text.
    static const std::regex form(
        R"(^((?:ERROR|WARNING): )?(\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\)) ?: ?(.*)$)");
    std::smatch match;
    if (!std::regex_match(message, match, form))
        return message;
    const std::string number = match[2].str();
    std::size_t source = files.size();
    std::from_chars(number.data(), number.data() + number.size(), source);
    if (source >= files.size())
        return message;
    return fmt::format("{}:{}: {}{}", files[source], match[3].str() + match[4].str(),
                       match[1].str(), match[5].str());
}

}  // namespace

std::string locateMessages(std::string_view log, const std::vector<std::string>& files) {
    std::istringstream lines{std::string(log)};
    std::string located;
    for (std::string line; std::getline(lines, line);) {
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\0'))
            line.pop_back();
        if (line.empty())
            continue;
        if (!located.empty())
            located += '\n';
        located += locateMessage(line, files);
    }
    return located;
}

}  // namespace relievo::gl

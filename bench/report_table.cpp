#include "bench/report_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace relievo::bench {

namespace {

nlohmann::ordered_json cellJson(const ReportCell& cell) {
    return std::visit(
        [](const auto& value) -> nlohmann::ordered_json {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
                return nullptr;
            else
                return value;
        },
        cell);
}

}  // namespace

std::string cellText(const ReportCell& cell, const ReportColumn& column) {
    if (const auto* text = std::get_if<std::string>(&cell))
        return *text;
    if (const auto* integer = std::get_if<std::int64_t>(&cell))
        return fmt::format("{}", *integer);
    if (const auto* number = std::get_if<double>(&cell))
        return fmt::format("{:.{}g}", *number, column.significantDigits);
    return "-";
}

bool isTextColumn(const ReportTable& table, std::size_t column) {
    return std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
        return std::holds_alternative<std::string>(row[column]);
    });
}

std::string formatTable(const ReportTable& table) {
    std::vector<std::vector<std::string>> lines(1 + table.rows.size());
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        lines[0].push_back(table.columns[c].heading);
        std::size_t width = table.columns[c].heading.size();
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            assert(table.rows[r].size() == table.columns.size());
            lines[r + 1].push_back(cellText(table.rows[r][c], table.columns[c]));
            width = std::max(width, lines[r + 1].back().size());
        }
        const bool left = isTextColumn(table, c);
        for (auto& line : lines)
            line[c] = left ? fmt::format("{:<{}}", line[c], width)
                           : fmt::format("{:>{}}", line[c], width);
    }
    std::vector<std::string> joined;
    for (const auto& line : lines)
        joined.push_back(fmt::format("{}", fmt::join(line, "  ")));
    return fmt::format("{}", fmt::join(joined, "\n"));
}

nlohmann::ordered_json rowsAsJson(const ReportTable& table) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const auto& row : table.rows) {
        nlohmann::ordered_json object;
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            object[table.columns[c].key] = cellJson(row[c]);
        rows.push_back(std::move(object));
    }
    return rows;
}

}  // namespace relievo::bench

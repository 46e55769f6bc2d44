#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

namespace relievo::bench {

/// A column of a report: its key in JSON, its heading in text and the digits of its numbers there.
struct ReportColumn {
    std::string key;
    std::string heading;
    int significantDigits = 4;
};

/// A value, or nothing where a measurement does not apply.
using ReportCell = std::variant<std::monostate, std::string, std::int64_t, double>;

/// What a benchmark measured: one row a measurement, as many cells a row as there are columns.
struct ReportTable {
    std::vector<ReportColumn> columns;
    std::vector<std::vector<ReportCell>> rows;
};

/// A cell as the table shows it; "-" for nothing.
std::string cellText(const ReportCell& cell, const ReportColumn& column);

/// Whether any cell of the column is text.
bool isTextColumn(const ReportTable& table, std::size_t column);

/// The table as lines of text with a line of headings: columns at least two spaces apart, words to
/// the left and numbers to the right, "-" for nothing. No line end after the last line.
std::string formatTable(const ReportTable& table);

/// The rows as an array of objects; numbers with all their digits, null for nothing and for numbers
/// that are not finite.
nlohmann::ordered_json rowsAsJson(const ReportTable& table);

}  // namespace relievo::bench

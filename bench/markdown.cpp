#include "bench/markdown.h"

#include <fmt/format.h>

namespace relievo::bench {

std::string markdownTable(const ReportTable& table) {
    std::string headings;
    std::string rule;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        headings += fmt::format("| {} ", table.columns[c].heading);
        rule += isTextColumn(table, c) ? "|---" : "|---:";
    }
    std::string text = headings + "|\n" + rule + "|\n";
    for (const auto& row : table.rows) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            const bool isNothing = std::holds_alternative<std::monostate>(row[c]);
            text += fmt::format("| {} ", isNothing ? "–" : cellText(row[c], table.columns[c]));
        }
        text += "|\n";
    }
    return text;
}

std::string markdownDocument(const std::string& title, const std::vector<ReportSection>& sections) {
    std::string text = fmt::format("# {}\n", title);
    for (const ReportSection& section : sections) {
        text += fmt::format("\n## {}\n\n", section.title);
        if (!section.text.empty())
            text += section.text + "\n\n";
        text += markdownTable(section.table);
    }
    return text;
}

}  // namespace relievo::bench

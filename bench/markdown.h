#pragma once

#include <string>
#include <vector>

#include "bench/report_table.h"

namespace relievo::bench {

/// A table of a report with what is to be said about it.
struct ReportSection {
    std::string title;
    std::string text;  ///< Markdown; may be empty
    ReportTable table;
};

/// The table in Markdown, ready for docs/: a line of headings, numbers to the right, "–" for
/// nothing. Ends with a line end.
std::string markdownTable(const ReportTable& table);

/// A document: `title`, then the sections.
std::string markdownDocument(const std::string& title, const std::vector<ReportSection>& sections);

}  // namespace relievo::bench

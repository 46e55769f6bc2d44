#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/report_table.h"

namespace relievo::bench {

/// Numbers that belong to a row and a column, any count of them to each pair. Rows and columns
/// stand in the order in which they first come.
class MeasurementGrid {
  public:
    void add(const std::string& row, const std::string& column, double value);

    /// A table with `corner` over the names of the rows, and in each cell what `summary` makes of
    /// the numbers there; nothing where there are none.
    [[nodiscard]] ReportTable table(
        const std::string& corner,
        const std::function<ReportCell(const std::vector<double>&)>& summary) const;

  private:
    std::vector<std::string> rows_;
    std::vector<std::string> columns_;
    std::map<std::pair<std::string, std::string>, std::vector<double>> values_;
};

/// Summaries of at least one number.
ReportCell meanOf(const std::vector<double>& values);
ReportCell greatestOf(const std::vector<double>& values);
/// "0.91 – 3.2", or the number when both ends are the same.
ReportCell rangeOf(const std::vector<double>& values);

}  // namespace relievo::bench

#include "bench/measurement_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace relievo::bench {

namespace {

void note(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
}

}  // namespace

void MeasurementGrid::add(const std::string& row, const std::string& column, double value) {
    note(rows_, row);
    note(columns_, column);
    values_[{row, column}].push_back(value);
}

ReportTable MeasurementGrid::table(
    const std::string& corner,
    const std::function<ReportCell(const std::vector<double>&)>& summary) const {
    constexpr int kDigits = 3;
    ReportTable table;
    table.columns.push_back({corner, corner});
    for (const std::string& column : columns_)
        table.columns.push_back({column, column, kDigits});
    for (const std::string& row : rows_) {
        std::vector<ReportCell> cells{row};
        for (const std::string& column : columns_) {
            const auto found = values_.find({row, column});
            cells.push_back(found == values_.end() ? ReportCell() : summary(found->second));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

ReportCell meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

ReportCell greatestOf(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

ReportCell rangeOf(const std::vector<double>& values) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    const std::string low = fmt::format("{:.3g}", *least);
    const std::string high = fmt::format("{:.3g}", *greatest);
    return low == high ? low : fmt::format("{} – {}", low, high);
}

}  // namespace relievo::bench

#include "bench/report_table.h"

#include <gtest/gtest.h>

#include <limits>

namespace relievo::bench {
namespace {

ReportTable sampleTable() {
    ReportTable table;
    table.columns = {{"name", "name"}, {"count", "count"}, {"share", "share %", 3}};
    table.rows = {{std::string("noise"), std::int64_t{7}, 12.3456},
                  {std::string("a"), std::monostate(), std::numeric_limits<double>::infinity()}};
    return table;
}

TEST(ReportTable, TextIsAligned) {
    EXPECT_EQ(formatTable(sampleTable()),
              "name   count  share %\n"
              "noise      7     12.3\n"
              "a          -      inf");
}

TEST(ReportTable, WithoutRowsItIsItsHeadings) {
    ReportTable table = sampleTable();
    table.rows.clear();
    EXPECT_EQ(formatTable(table), "name  count  share %");
    EXPECT_EQ(rowsAsJson(table).dump(), "[]");
}

TEST(ReportTable, JsonKeepsAllDigitsAndIsValidForWhatIsNoNumber) {
    EXPECT_EQ(rowsAsJson(sampleTable()).dump(), R"([{"name":"noise","count":7,"share":12.3456},)"
                                                R"({"name":"a","count":null,"share":null}])");
}

}  // namespace
}  // namespace relievo::bench

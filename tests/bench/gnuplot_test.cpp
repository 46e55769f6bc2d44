#include "bench/gnuplot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/bench/scoped_path.h"
#include "tests/commands/process.h"

namespace relievo::bench {
namespace {

using testing::HasSubstr;
using testing::Not;

Plot samplePlot() {
    Plot plot;
    plot.title = "Bob's plot";
    plot.xLabel = "size";
    plot.yLabel = "time";
    seriesOf(plot, "first", "noise").points = {{1, 2}, {3, 4}};
    seriesOf(plot, "second", "waves").points = {{1, 5}};
    seriesOf(plot, "second", "noise").points = {{10, 6}};
    seriesOf(plot, "empty", "noise");
    return plot;
}

TEST(Gnuplot, SeriesAreFoundAgain) {
    Plot plot = samplePlot();
    EXPECT_EQ(plot.panels.size(), 3u);
    EXPECT_EQ(seriesOf(plot, "second", "noise").points.front().first, 10);
    EXPECT_EQ(plot.panels.size(), 3u);
    EXPECT_EQ(plot.panels[1].series.size(), 2u);
}

TEST(Gnuplot, ScriptQuotesTextAndKeepsColoursOfNames) {
    const std::string script = gnuplotScript(samplePlot(), "out put.svg");
    EXPECT_THAT(script, HasSubstr("'Bob''s plot'"));
    EXPECT_THAT(script, HasSubstr("'out put.svg'"));
    // "noise" is the first name of all, also where it is the second of its panel.
    EXPECT_THAT(script, HasSubstr("$data0_0 with linespoints linetype 1 title 'noise'"));
    EXPECT_THAT(script, HasSubstr("$data1_0 with linespoints linetype 2 title 'waves'"));
    EXPECT_THAT(script, HasSubstr("$data1_1 with linespoints linetype 1 title 'noise'"));
    EXPECT_THAT(script, Not(HasSubstr("$data2_0")));
}

TEST(Gnuplot, DrawsSvgWithEveryTitle) {
    const tests::ScratchFolder folder;
    drawPlot(samplePlot(), folder.file("plot.svg"));
    const std::string svg = tests::readBytes(folder.file("plot.svg"));
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_THAT(svg, HasSubstr("</svg>"));
    for (const char* text : {"Bob's plot", "first", "second", "noise", "waves"})
        EXPECT_THAT(svg, HasSubstr(text));
}

TEST(Gnuplot, DrawsPng) {
    const tests::ScratchFolder folder;
    drawPlot(samplePlot(), folder.file("plot"), PlotFormat::Png);
    EXPECT_TRUE(tests::readBytes(folder.file("plot")).starts_with("\x89PNG"));
    EXPECT_EQ(plotFormatOf("a/plot.png"), PlotFormat::Png);
    EXPECT_EQ(plotFormatOf("a/plot.svg"), PlotFormat::Svg);
    EXPECT_EQ(plotFormatOf("a/plot.pdf"), std::nullopt);
}

TEST(Gnuplot, PanelsToCompareHaveOneAxisAndNameTheirSeriesOnce) {
    Plot plot = samplePlot();
    plot.hasLegend = true;
    plot.hasOneRange = true;
    const std::string script = gnuplotScript(plot, "plot.svg");
    EXPECT_THAT(script, HasSubstr("set yrange [1:10]\nunset key"));
    EXPECT_THAT(script, HasSubstr("layout 2,2"));
    EXPECT_THAT(script, HasSubstr("NaN with linespoints linetype 1 title 'noise', \\\n"
                                  "     NaN with linespoints linetype 2 title 'waves'"));
    const tests::ScratchFolder folder;
    drawPlot(plot, folder.file("plot.svg"));
    EXPECT_THAT(tests::readBytes(folder.file("plot.svg")), HasSubstr("waves"));
    drawPlot(Plot{.title = "none",
                  .xLabel = "",
                  .yLabel = "",
                  .hasLegend = true,
                  .hasOneRange = true,
                  .panels = {}},
             folder.file("none.svg"));
}

TEST(Gnuplot, FailureToDrawIsAnError) {
    EXPECT_THROW(drawPlot(samplePlot(), "/no-such-folder/plot.svg"), std::runtime_error);
    Plot plot = samplePlot();
    plot.panels[0].series[0].points = {{-1, -1}};  // nothing to show on logarithmic axes
    const tests::ScratchFolder folder;
    EXPECT_THROW(drawPlot(plot, folder.file("plot.svg")), std::runtime_error);
}

TEST(Gnuplot, AMissingGnuplotIsFoundOutBeforehand) {
    EXPECT_NO_THROW(requireGnuplot());
    const tests::ScratchFolder empty;
    const tests::ScopedPath path(empty.path());
    EXPECT_THROW(requireGnuplot(), std::runtime_error);
}

}  // namespace
}  // namespace relievo::bench

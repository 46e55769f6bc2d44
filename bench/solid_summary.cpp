#include "bench/solid_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>

#include "bench/measurement_grid.h"

namespace relievo::bench {
namespace {

constexpr const char* kOurs = "solid";
constexpr double kNever = std::numeric_limits<double>::infinity();

std::string columnOf(const SolidMeasurement& m) {
    return fmt::format("{}°", m.elevation);
}

std::string rowOf(const SolidMeasurement& m) {
    return fmt::format("{}: {}", m.solid, m.technique);
}

std::string techniqueOf(const SolidMeasurement& m) {
    return m.technique;
}

double fetchesOf(const SolidMeasurement& m) {
    return m.work.meanFetches;
}

double secondsOf(const SolidMeasurement& m) {
    return m.seconds;
}

// One number of every measurement with the default budget: a row a solid and technique, a column an
// elevation.
template <typename Value>
ReportTable atDefaults(const std::vector<SolidMeasurement>& measurements, const Value& value) {
    MeasurementGrid grid;
    for (const SolidMeasurement& m : measurements)
        if (m.isDefault)
            grid.add(rowOf(m), columnOf(m), value(m));
    return grid.table("solid and search", meanOf);
}

// What the searches of solids get wrong, over shapes and elevations.
ReportTable faultTable(const std::vector<SolidMeasurement>& measurements) {
    MeasurementGrid grid;
    for (const SolidMeasurement& m : measurements) {
        if (!m.isDefault || m.isRelief)
            continue;
        const auto add = [&grid, row = rowOf(m)](const char* column, double value) {
            grid.add(row, column, value);
        };
        add("fetches", fetchesOf(m));
        add("wrong %", 100.0 * m.errors.wrongShare);
        add("behind %", 100.0 * m.faults.behind);
        add("lost %", 100.0 * m.faults.lost);
        add("in front %", 100.0 * m.faults.inFront);
        add("exhausted %", 100.0 * m.errors.unconvergedShare);
    }
    return grid.table("solid and search", meanOf);
}

// Measurements that differ in their budgets only.
using SeriesKey = std::tuple<std::string, std::string, int, double, std::string>;
using SeriesOfBudgets = std::map<SeriesKey, std::vector<SolidMeasurement>>;

SeriesKey keyOf(const SolidMeasurement& m, const std::string& technique) {
    return {m.solid, m.shape, m.size, m.elevation, technique};
}

SeriesOfBudgets byBudget(const std::vector<SolidMeasurement>& measurements) {
    SeriesOfBudgets series;
    for (const SolidMeasurement& m : measurements)
        series[keyOf(m, m.technique)].push_back(m);
    return series;
}

// The least cost of those that have at most that share of wrong hits.
template <typename Cost>
double leastCost(const std::vector<SolidMeasurement>& budgets, double wrongShare,
                 const Cost& cost) {
    double least = kNever;
    for (const SolidMeasurement& m : budgets)
        if (m.errors.wrongShare <= wrongShare)
            least = std::min(least, cost(m));
    return least;
}

template <typename Cost>
std::optional<double> atEqualError(const std::vector<SolidMeasurement>& ours,
                                   const std::vector<SolidMeasurement>& theirs, const Cost& cost) {
    double fewest = kNever;
    for (const SolidMeasurement& m : theirs)
        fewest = std::min(fewest, m.errors.wrongShare);
    const double wrongShare = 1.02 * fewest;
    const double ratio = leastCost(ours, wrongShare, cost) / leastCost(theirs, wrongShare, cost);
    return ratio < kNever ? std::optional(ratio) : std::nullopt;
}

// Of each solid, shape and elevation every other search, with the measurements of ours and its own.
template <typename Work>
void withOurs(const std::vector<SolidMeasurement>& measurements, const Work& work) {
    const SeriesOfBudgets series = byBudget(measurements);
    for (const SolidMeasurement& m : measurements) {
        const auto ours = series.find(keyOf(m, kOurs));
        if (m.isDefault && m.technique != kOurs && ours != series.end())
            work(m, ours->second, series.at(keyOf(m, m.technique)));
    }
}

using Summary = ReportCell (*)(const std::vector<double>&);

ReportCell nothingUnlessAll(const std::vector<double>& values, Summary summary) {
    return greatestOf(values) == ReportCell(kNever) ? ReportCell() : summary(values);
}

// Ours over theirs: a row for each that `row` makes of measurements, a column an elevation.
template <typename Cost>
ReportTable ratiosAtEqualError(const std::vector<SolidMeasurement>& measurements, const Cost& cost,
                               std::string (*row)(const SolidMeasurement&), Summary summary) {
    MeasurementGrid grid;
    withOurs(measurements, [&](const SolidMeasurement& m, const auto& ours, const auto& theirs) {
        grid.add(row(m), columnOf(m), atEqualError(ours, theirs, cost).value_or(kNever));
    });
    return grid.table("search", [summary](const std::vector<double>& values) {
        return nothingUnlessAll(values, summary);
    });
}

// The range of the ratios, and of how many cases there is one.
ReportCell rangeAndCount(const std::vector<double>& ratios) {
    std::vector<double> known;
    std::ranges::copy_if(ratios, std::back_inserter(known),
                         [](double r) { return !std::isnan(r); });
    if (known.empty())
        return {};
    return fmt::format("{} ({} of {})", std::get<std::string>(rangeOf(known)), known.size(),
                       ratios.size());
}

// Ours over theirs: a row a search, a column a share of wrong hits.
ReportTable ratiosWithin(const std::vector<SolidMeasurement>& measurements) {
    MeasurementGrid grid;
    withOurs(measurements, [&](const SolidMeasurement& m, const auto& ours, const auto& theirs) {
        for (const double percent : {20.0, 10.0, 5.0, 2.0, 1.0, 0.5})
            grid.add(m.technique, fmt::format("{} %", percent),
                     fetchesWithin(ours, theirs, 0.01 * percent)
                         .value_or(std::numeric_limits<double>::quiet_NaN()));
    });
    return grid.table("search", rangeAndCount);
}

ReportTable costWithin(const std::vector<SolidMeasurement>& measurements, double wrongShare) {
    const SeriesOfBudgets series = byBudget(measurements);
    MeasurementGrid grid;
    for (const SolidMeasurement& m : measurements)
        if (m.isDefault)
            grid.add(rowOf(m), columnOf(m),
                     leastCost(series.at(keyOf(m, m.technique)), wrongShare, fetchesOf));
    return grid.table("solid and search", [](const std::vector<double>& values) {
        return nothingUnlessAll(values, meanOf);
    });
}

// What profiles cost against upright walls, with our search.
ReportTable profileTable(const std::vector<SolidMeasurement>& measurements) {
    std::map<SeriesKey, double> basic;
    for (const SolidMeasurement& m : measurements)
        if (m.technique == kOurs && m.isDefault && m.solid == "basic")
            basic[keyOf(m, "")] = fetchesOf(m);
    MeasurementGrid grid;
    for (const SolidMeasurement& m : measurements) {
        SolidMeasurement upright = m;
        upright.solid = "basic";
        const auto found = basic.find(keyOf(upright, ""));
        if (m.technique == kOurs && m.isDefault && m.solid != "basic" && found != basic.end())
            grid.add(m.solid, columnOf(m), fetchesOf(m) / found->second);
    }
    return grid.table("solid", rangeOf);
}

}  // namespace

std::optional<double> fetchesWithin(const std::vector<SolidMeasurement>& ours,
                                    const std::vector<SolidMeasurement>& theirs,
                                    double wrongShare) {
    const double other = leastCost(theirs, wrongShare, fetchesOf);
    if (!(other < kNever))
        return std::nullopt;
    return leastCost(ours, wrongShare, fetchesOf) / other;
}

std::optional<double> fetchesAtEqualError(const std::vector<SolidMeasurement>& ours,
                                          const std::vector<SolidMeasurement>& theirs) {
    return atEqualError(ours, theirs, fetchesOf);
}

std::vector<ReportSection> summariseSolids(const std::vector<SolidMeasurement>& measurements) {
    if (measurements.empty())
        return {};
    return {
        {"What searches of solids get wrong",
         "With the defaults, in % of the rays, mean over shapes and elevations. Behind: a hit over "
         "a texel behind the first one, as when a step leads through a chamfer (tunnelling). Lost: "
         "the solid is not hit at all, as behind the first replica of a revolution. In front: a "
         "hit "
         "over a texel before the first one, or where there is none. Exhausted: the steps ran out, "
         "which the printed searches shade as if it was a hit (streaks). Wrong is all of these, "
         "and lookups are a ray's.",
         faultTable(measurements)},
        {"Wrong first hits",
         "Off by over a texel along the ray from the solid that the shape map defines, or not "
         "converged; in % of the rays, with the defaults, mean over the shapes.",
         atDefaults(measurements,
                    [](const SolidMeasurement& m) { return 100.0 * m.errors.wrongShare; })},
        {"Texture lookups", "A ray, with the defaults, mean over the shapes.",
         atDefaults(measurements, fetchesOf)},
        {"Time", "Milliseconds a frame, with the defaults, mean over the shapes.",
         atDefaults(measurements, [](const SolidMeasurement& m) { return 1e3 * m.seconds; })},
        {"Lookups for at most 1 % of wrong hits",
         "A ray, with the cheapest budget that comes to it, mean over the shapes; – where for some "
         "shape none does.",
         costWithin(measurements, 0.01)},
        {"Our lookups at equal error",
         "Over those of the other search: that with the cheapest budget with which it is within 2 "
         "% "
         "of the fewest wrong hits that it comes to, ours with the cheapest one with which it has "
         "no more. From the least to the greatest ratio over solids and shapes; – where for some "
         "of "
         "them ours never does.",
         ratiosAtEqualError(measurements, fetchesOf, techniqueOf, rangeOf)},
        {"Our lookups for at most so many wrong hits",
         "Over those of the other search, each with the cheapest budget with which no more of the "
         "rays are wrong. From the least to the greatest ratio over solids, shapes and elevations, "
         "of how many of these the other search comes to it.",
         ratiosWithin(measurements)},
        {"Our lookups at equal error, solid by solid", "Likewise, mean over the shapes.",
         ratiosAtEqualError(measurements, fetchesOf, rowOf, meanOf)},
        {"Our time at equal error", "Likewise.",
         ratiosAtEqualError(measurements, secondsOf, rowOf, meanOf)},
        {"Lookups of profiles over those of upright walls",
         "Of our search, for the same shape and elevation: from the least to the greatest ratio "
         "over the shapes.",
         profileTable(measurements)},
    };
}

}  // namespace relievo::bench

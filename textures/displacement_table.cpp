#include "textures/displacement_table.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "textures/input_error.h"

namespace relievo::textures {
namespace {

// The numbers, all finite, in an attribute that separates them by spaces; `count` of them.
std::vector<double> numbersOf(const MapSet& maps, const std::string& attribute, std::size_t count) {
    const auto found = maps.attributes.find(attribute);
    if (found == maps.attributes.end())
        throw InputError(
            fmt::format("lacks the attribute '{}' of its map of displacements", attribute));
    const std::string_view text = found->second;
    std::vector<double> numbers;
    std::size_t place = 0;
    while (place < text.size()) {
        double number = 0.0;
        const auto [stop, error] =
            std::from_chars(text.data() + place, text.data() + text.size(), number);
        if (error != std::errc() || !std::isfinite(number))
            break;
        numbers.push_back(number);
        place = static_cast<std::size_t>(stop - text.data());
        if (place < text.size() && text[place] == ' ')
            ++place;
    }
    if (place < text.size() || numbers.size() != count)
        throw InputError(fmt::format("its attribute '{}' is '{}{}', expected {} numbers", attribute,
                                     text.substr(0, 40), text.size() > 40 ? "…" : "", count));
    return numbers;
}

struct Views {
    std::size_t azimuths;
    std::size_t elevations;
    std::size_t curvatures;
    double scale;

    [[nodiscard]] std::size_t plane() const noexcept { return curvatures / 2; }
    // The depth of a hit is this times its distance.
    [[nodiscard]] double depthOf(std::size_t elevation) const {
        return std::sin(std::numbers::pi / 2.0 * static_cast<double>(elevation + 1) /
                        static_cast<double>(elevations)) /
               scale;
    }
};

// A number of views from 1 to a million, more than any table has.
std::size_t viewCount(double number) {
    if (!(number >= 1.0 && number <= 1e6) || std::nearbyint(number) != number)
        throw InputError(fmt::format(
            "its attribute 'relievo:vdm-views' has {}, expected whole numbers from 1", number));
    return static_cast<std::size_t>(number);
}

Views viewsOf(const MapSet& maps) {
    const std::vector<double> numbers = numbersOf(maps, "relievo:vdm-views", 3);
    const double scale = numbersOf(maps, "relievo:vdm-scale", 1).front();
    if (!(scale > 0.0))
        throw InputError(fmt::format(
            "its attribute 'relievo:vdm-scale' is {}, expected a number above 0", scale));
    return {viewCount(numbers[0]), viewCount(numbers[1]), viewCount(numbers[2]), scale};
}

const Plane* planeOf(const MapSet& maps, std::string_view channel, std::size_t number) {
    const std::string name = fmt::format("{}{}", channel, number);
    const Plane* const plane = maps.find(name);
    if (plane == nullptr)
        throw InputError(fmt::format("lacks the channel '{}' of its map of displacements", name));
    return plane;
}

DisplacementTable wholeTable(const MapSet& maps, const Views& views) {
    DisplacementTable table{static_cast<int>(views.azimuths), {}, {}};
    const std::size_t first = views.plane() * views.elevations * views.azimuths;
    for (std::size_t k = 0; k < views.elevations * views.azimuths; ++k)
        table.factors.push_back(planeOf(maps, "vdm", first + k));
    for (std::size_t elevation = 0; elevation < views.elevations; ++elevation) {
        table.weights.emplace_back(views.elevations, 0.0f)[elevation] =
            static_cast<float>(views.depthOf(elevation));
    }
    return table;
}

DisplacementTable packedTable(const MapSet& maps, const Views& views) {
    DisplacementTable table{static_cast<int>(views.azimuths), {}, {}};
    while (maps.find(fmt::format("vdmfactor{}", table.factors.size())) != nullptr)
        table.factors.push_back(planeOf(maps, "vdmfactor", table.factors.size()));
    if (table.factors.size() % views.azimuths != 0)
        throw InputError(
            fmt::format("has {} channels 'vdmfactor', expected some for each of {} azimuths",
                        table.factors.size(), views.azimuths));
    const std::size_t terms = table.factors.size() / views.azimuths;
    const std::size_t columns = views.elevations * views.curvatures;
    const std::vector<double> weights = numbersOf(maps, "relievo:vdm-weights", terms * columns);
    for (std::size_t elevation = 0; elevation < views.elevations; ++elevation) {
        std::vector<float>& row = table.weights.emplace_back();
        for (std::size_t term = 0; term < terms; ++term)
            row.push_back(static_cast<float>(
                views.depthOf(elevation) *
                weights[term * columns + views.plane() * views.elevations + elevation]));
    }
    return table;
}

}  // namespace

DisplacementTable displacementTableOf(const MapSet& maps) {
    const bool isPacked = maps.find("vdmfactor0") != nullptr;
    if (!isPacked && maps.find("vdm0") == nullptr)
        return {};
    const Views views = viewsOf(maps);
    return isPacked ? packedTable(maps, views) : wholeTable(maps, views);
}

}  // namespace relievo::textures

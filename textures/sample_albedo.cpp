#include "textures/sample_albedo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "textures/input_error.h"
#include "textures/lattice_noise.h"
#include "textures/sample_reliefs.h"

namespace relievo::textures {

namespace {

/// Ground to feature, lighter or darker and a little warmer or colder by the part, and by fine
/// noise everywhere.
SampleColour albedoAt(const SampleRelief& relief, double u, double v, const SampleTile& tile) {
    const SampleSurface surface = relief.surface(u, v, tile);
    const double blend = std::clamp(surface.feature, 0.0, 1.0);
    const int rows = tile.rows(48);
    const double grain = fractalNoise(u * 48.0, v * rows, 48, rows, 2, tile.seed + 31u);
    const double lightness = (surface.part & 0xFFu) / 255.0 - 0.5;
    const double warmth = ((surface.part >> 12u) & 0xFFu) / 255.0 - 0.5;
    const double gain = 1.0 + 0.07 * grain + blend * relief.variety * lightness;
    const double tint = 0.3 * blend * relief.variety * warmth;
    return {std::lerp(relief.ground.red, relief.feature.red, blend) * (gain + tint),
            std::lerp(relief.ground.green, relief.feature.green, blend) * gain,
            std::lerp(relief.ground.blue, relief.feature.blue, blend) * (gain - tint)};
}

}  // namespace

std::array<Plane, 3> generateSampleAlbedo(std::string_view name, int width, int height,
                                          std::uint32_t seed) {
    const SampleRelief& relief = findSampleRelief(name);
    if (width < 1 || height < 1)
        throw InputError(fmt::format("a sample albedo of {} x {} texels, expected at least 1 x 1",
                                     width, height));
    const SampleTile tile{static_cast<double>(height) / width, seed};
    std::array<Plane, 3> planes{Plane(width, height), Plane(width, height), Plane(width, height)};
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const SampleColour colour =
                albedoAt(relief, (i + 0.5) / width, (j + 0.5) / height, tile);
            planes[0].at(i, j) = static_cast<float>(std::clamp(colour.red, 0.0, 1.0));
            planes[1].at(i, j) = static_cast<float>(std::clamp(colour.green, 0.0, 1.0));
            planes[2].at(i, j) = static_cast<float>(std::clamp(colour.blue, 0.0, 1.0));
        }
    return planes;
}

}  // namespace relievo::textures

// Signs and rounding of distances, many texels at a time: oriented_distances.cpp. Compiled once for
// each generation of processors (for_each_processor.h).

inline void orientKernel(const OrientedTexels& texels) {
    const std::size_t count = texels.inside.size();
    const std::uint8_t* const inside = texels.inside.data();
    float* const distance = texels.distance.data();
    float* const awayX = texels.awayX.data();
    float* const awayY = texels.awayY.data();
    float* const shape = texels.shape.data();
    for (std::size_t t = 0; t < count; ++t) {
        const bool isInside = inside[t] != 0;
        const float sign = isInside && distance[t] > 0.0f ? -1.0f : 1.0f;
        const float least = isInside ? 0.5f : 0.0f;
        const float most = isInside ? 1.0f : 0.5f;
        const float raised = shape[t] < least ? least : shape[t];
        distance[t] *= sign;
        awayX[t] *= sign;
        awayY[t] *= sign;
        shape[t] = raised > most ? most : raised;
    }
}

// Eight of them; `most` of each of eight columns.
inline void makeSure(float* distances, double width, double longest, Doubles& most) {
    EightFloats given;
    std::memcpy(&given, distances, sizeof(given));
    const Doubles values = __builtin_convertvector(given, Doubles);
    const Doubles measured = values < 0.0 ? -values : values;
    const Doubles off = kMeasuredRelativeError * (measured + longest) + kMeasuredAbsoluteError;
    const Doubles left = measured - off;
    const Doubles length = (left > 0.0 ? left : Doubles{}) / width;
    EightFloats sure = __builtin_convertvector(length, EightFloats);
    // The float before one above 0 has the number before it; the mask is −1 where one is too large.
    const auto isLarger =
        __builtin_convertvector(__builtin_convertvector(sure, Doubles) > length, EightInts);
    sure = reinterpret_cast<EightFloats>(reinterpret_cast<EightInts>(sure) + isLarger);
    const Doubles farther = (measured + off) / width - __builtin_convertvector(sure, Doubles);
    most = farther > most ? farther : most;
    const EightInts sign =
        reinterpret_cast<EightInts>(given) & std::numeric_limits<std::int32_t>::min();
    sure = reinterpret_cast<EightFloats>(reinterpret_cast<EightInts>(sure) | sign);
    std::memcpy(distances, &sure, sizeof(sure));
}

inline double makeSureKernel(std::span<float> distances, double width, double longest) {
    Doubles most{};
    std::size_t t = 0;
    for (; t + kEight <= distances.size(); t += kEight)
        makeSure(&distances[t], width, longest, most);
    // Zeros are farther by less than anything measured.
    std::array<float, kEight> rest{};
    const auto left = distances.subspan(t);
    std::ranges::copy(left, rest.begin());
    makeSure(rest.data(), width, longest, most);
    std::copy_n(rest.begin(), left.size(), left.begin());
    double greatest = 0.0;
    for (int k = 0; k < kEight; ++k)
        greatest = std::max(greatest, most[k]);
    return greatest;
}

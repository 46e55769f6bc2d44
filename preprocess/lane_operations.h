// Operations on lanes (lanes.h). No include guard: kernels include it once for each generation of
// processors, inside a namespace of its own (for_each_processor.h), because what is compiled for
// one generation cannot be inlined into what is compiled for another without loss.

inline Lanes splat(float value) {
    return Lanes{} + value;
}
inline Lanes loadLanes(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof(lanes));
    return lanes;
}
inline void storeLanes(Lanes lanes, float* to) {
    std::memcpy(to, &lanes, sizeof(lanes));
}
inline Lanes larger(Lanes a, Lanes b) {
    return a > b ? a : b;
}
inline Lanes smaller(Lanes a, Lanes b) {
    return a < b ? a : b;
}

// Whether some lane of the mask is true.
inline bool anyLane(LaneMask mask) {
#if defined(__AVX512DQ__)
    return _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask)) != 0;
#else
    std::int64_t words[8];
    std::memcpy(words, &mask, sizeof(mask));
    return ((words[0] | words[1]) | (words[2] | words[3]) | (words[4] | words[5]) |
            (words[6] | words[7])) != 0;
#endif
}

inline float largestLane(Lanes lanes) {
    using Quarter = float __attribute__((vector_size(16)));
    Quarter quarters[4];
    std::memcpy(quarters, &lanes, sizeof(lanes));
    const Quarter first = quarters[0] > quarters[1] ? quarters[0] : quarters[1];
    const Quarter second = quarters[2] > quarters[3] ? quarters[2] : quarters[3];
    const Quarter both = first > second ? first : second;
    const float left = both[0] > both[1] ? both[0] : both[1];
    const float right = both[2] > both[3] ? both[2] : both[3];
    return left > right ? left : right;
}
inline float smallestLane(Lanes lanes) {
    return -largestLane(-lanes);
}

// Left alone, the compiler takes these two through memory where a register would do, and the
// processor waits for it.
inline Lanes squareRoots(Lanes lanes) {
#if defined(__AVX512DQ__)
    return _mm512_sqrt_ps(lanes);
#else
    float values[kLanes];
    std::memcpy(values, &lanes, sizeof(lanes));
    for (float& value : values)
        value = std::sqrt(value);
    std::memcpy(&lanes, values, sizeof(lanes));
    return lanes;
#endif
}
inline Lanes fourTimes(Four four) {
#if defined(__AVX512DQ__)
    return _mm512_broadcast_f32x4(four);
#else
    return __builtin_shufflevector(four, four, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
#endif
}

// from[index] for each lane.
inline Lanes gatherLanes(const float* from, LaneMask index) {
#if defined(__AVX512DQ__)
    return _mm512_i32gather_ps(reinterpret_cast<__m512i>(index), from, sizeof(float));
#else
    Lanes lanes;
    for (int k = 0; k < kLanes; ++k)
        lanes[k] = from[index[k]];
    return lanes;
#endif
}

// Rounded up to floats with `bits` < 23 significant bits after the first: the least such number
// that is not below. For lanes ≥ 0.
inline Lanes roundedUp(Lanes lanes, int bits) {
    const std::int32_t rest = (1 << (23 - bits)) - 1;
    LaneMask words;
    std::memcpy(&words, &lanes, sizeof(lanes));
    words = (words + rest) & ~rest;
    std::memcpy(&lanes, &words, sizeof(lanes));
    return lanes;
}

// Rounded down likewise: the largest such number that is not above.
inline Lanes roundedDown(Lanes lanes, int bits) {
    const std::int32_t rest = (1 << (23 - bits)) - 1;
    LaneMask words;
    std::memcpy(&words, &lanes, sizeof(lanes));
    words &= ~rest;
    std::memcpy(&lanes, &words, sizeof(lanes));
    return lanes;
}

// Operations on lanes (lanes.h). No include guard: kernels include it once for each generation of
// processors, inside a namespace of its own (for_each_processor.h), because what is compiled for
// one generation cannot be inlined into what is compiled for another without loss.

#if RELIEVO_KERNEL_AVX512
// Of the forms without a mask g++ 12 warns that they use something that is not initialised.
constexpr __mmask16 kEveryLane = 0xffff;
#endif

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
inline LaneMask loadMask(const std::int32_t* from) {
    LaneMask mask;
    std::memcpy(&mask, from, sizeof(mask));
    return mask;
}
inline void storeMask(LaneMask mask, std::int32_t* to) {
    std::memcpy(to, &mask, sizeof(mask));
}
// Of the compiler's own making these would be a comparison and a choice.
inline Lanes larger(Lanes a, Lanes b) {
#if RELIEVO_KERNEL_AVX512
    return _mm512_maskz_max_ps(kEveryLane, a, b);
#else
    return a > b ? a : b;
#endif
}
inline Lanes smaller(Lanes a, Lanes b) {
#if RELIEVO_KERNEL_AVX512
    return _mm512_maskz_min_ps(kEveryLane, a, b);
#else
    return a < b ? a : b;
#endif
}

// Whether some lane of the mask is true.
inline bool anyLane(LaneMask mask) {
#if RELIEVO_KERNEL_AVX512
    return _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask)) != 0;
#else
    std::int64_t words[8];
    std::memcpy(words, &mask, sizeof(mask));
    return ((words[0] | words[1]) | (words[2] | words[3]) | (words[4] | words[5]) |
            (words[6] | words[7])) != 0;
#endif
}

// How many lanes of the mask are true.
inline std::size_t countLanes(LaneMask mask) {
#if RELIEVO_KERNEL_AVX512
    return static_cast<std::size_t>(
        __builtin_popcount(_mm512_movepi32_mask(reinterpret_cast<__m512i>(mask))));
#else
    std::size_t count = 0;
    for (int k = 0; k < kLanes; ++k)
        count += mask[k] != 0 ? 1 : 0;
    return count;
#endif
}

// The first lane where the mask is true; there is one.
inline int firstLane(LaneMask mask) {
#if RELIEVO_KERNEL_AVX512
    return __builtin_ctz(
        static_cast<unsigned>(_mm512_movepi32_mask(reinterpret_cast<__m512i>(mask))));
#else
    int lane = 0;
    while (mask[lane] == 0)
        ++lane;
    return lane;
#endif
}

// The lanes where the mask is true, moved together to the first ones.
inline LaneMask compressMask(LaneMask lanes, LaneMask mask) {
#if RELIEVO_KERNEL_AVX512
    return reinterpret_cast<LaneMask>(_mm512_maskz_compress_epi32(
        _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask)), reinterpret_cast<__m512i>(lanes)));
#else
    std::int32_t values[kLanes] = {};
    int count = 0;
    for (int k = 0; k < kLanes; ++k) {
        values[count] = lanes[k];
        count += mask[k] != 0 ? 1 : 0;
    }
    return loadMask(values);
#endif
}
inline Lanes compressLanes(Lanes lanes, LaneMask mask) {
    return reinterpret_cast<Lanes>(compressMask(reinterpret_cast<LaneMask>(lanes), mask));
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
#if RELIEVO_KERNEL_AVX512
    return _mm512_maskz_sqrt_ps(kEveryLane, lanes);
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
#if RELIEVO_KERNEL_AVX512
    return _mm512_maskz_broadcast_f32x4(kEveryLane, four);
#else
    return __builtin_shufflevector(four, four, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
#endif
}

// from[index] for each lane.
inline Lanes gatherLanes(const float* from, LaneMask index) {
#if RELIEVO_KERNEL_AVX512
    return _mm512_mask_i32gather_ps(_mm512_setzero_ps(), kEveryLane,
                                    reinterpret_cast<__m512i>(index), from, sizeof(float));
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

// The steepest chord of a table (chord_table.h) for sixteen texels. No include guard: see
// for_each_processor.h.

#include "preprocess/lane_operations.h"

// Over the rings of one apex, whose depth is given; goes on in `sample`.
inline Lanes steepestFrom(Lanes depth, const float* texel, const ChordTable::Ring* ring, int rings,
                          const std::ptrdiff_t*& sample) {
    Lanes slope{};
    for (const ChordTable::Ring* const end = ring + rings; ring != end; ++ring) {
        Lanes least = loadLanes(texel + *sample++);
        for (int k = 1; k < ring->samples; ++k)
            least = smaller(least, loadLanes(texel + *sample++));
        slope = larger(slope, (depth - least) * ring->perLength);
    }
    return slope;
}

// For the texel with the centre sample `texel` and the fifteen to its right, in depth per texel
// width; 0 where no chord rises.
inline Lanes steepestChords(const ChordTable& chords, const float* texel) {
    Lanes slope{};
    const std::ptrdiff_t* sample = chords.samples().data();
    const ChordTable::Ring* ring = chords.rings().data();
    for (const ChordTable::Apex& apex : chords.apexes()) {
        slope = larger(slope,
                       steepestFrom(loadLanes(texel + apex.step), texel, ring, apex.rings, sample));
        ring += apex.rings;
    }
    return slope;
}

[[gnu::flatten]] inline void steepestChordsOfBlock(const ChordTable& chords,
                                                   const SampleLattice& lattice,
                                                   BlockValues& slopes) {
    for (int j = 0; j < kBlockSize; ++j)
        for (int i = 0; i < kBlockSize; i += kLanes)
            storeLanes(steepestChords(chords, lattice.texel(i, j)), &slopes[blockIndex(i, j)]);
}

// Of a table with one apex for each texel, at the depths of a block.
[[gnu::flatten]] inline void steepestChordsFrom(const BlockValues& depths, const ChordTable& chords,
                                                const SampleLattice& lattice, BlockValues& slopes) {
    const int rings = chords.apexes().front().rings;
    for (int j = 0; j < kBlockSize; ++j)
        for (int i = 0; i < kBlockSize; i += kLanes) {
            const std::ptrdiff_t* sample = chords.samples().data();
            storeLanes(steepestFrom(loadLanes(&depths[blockIndex(i, j)]), lattice.texel(i, j),
                                    chords.rings().data(), rings, sample),
                       &slopes[blockIndex(i, j)]);
        }
}

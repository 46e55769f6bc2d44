// The steepest chord of a table (chord_table.h) for sixteen texels. No include guard: see
// for_each_processor.h.

#include "preprocess/lane_operations.h"

// For the texel with the centre sample `texel` and the fifteen to its right, in depth per texel
// width; 0 where no chord rises.
inline Lanes steepestChords(const ChordTable& chords, const float* texel) {
    Lanes slope{};
    const std::ptrdiff_t* sample = chords.samples().data();
    const ChordTable::Ring* ring = chords.rings().data();
    for (const ChordTable::Apex& apex : chords.apexes()) {
        const Lanes depth = loadLanes(texel + apex.step);
        for (const ChordTable::Ring* const end = ring + apex.rings; ring != end; ++ring) {
            Lanes least = loadLanes(texel + *sample++);
            for (int k = 1; k < ring->samples; ++k)
                least = smaller(least, loadLanes(texel + *sample++));
            slope = larger(slope, (depth - least) * ring->perLength);
        }
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

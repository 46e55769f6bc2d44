#!/usr/bin/env bash
# Fuzzes the readers of map files and of their metadata: scripts/fuzz.sh [MINUTES for each, 10].
# Needs clang with libFuzzer (Debian: clang-14 and libclang-rt-14-dev). New inputs are kept in
# build/fuzz/corpus, one that breaks something in build/fuzz; put it into tests/fuzz/corpus.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

minutes=${1:-10}
cmake -G Ninja -B build/fuzz -DCMAKE_BUILD_TYPE=RelWithDebInfo -DRELIEVO_FUZZ=ON \
    -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14
cmake --build build/fuzz --target map_file_fuzzer metadata_fuzzer

# The image libraries keep tables to the end, which is no leak of ours. They are not instrumented.
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1
for target in map_file metadata; do
    mkdir -p "build/fuzz/corpus/$target"
    "build/fuzz/bin/${target}_fuzzer" -max_total_time=$((minutes * 60)) -timeout=10 \
        -rss_limit_mb=2048 -max_len=20000 -print_final_stats=1 -verbosity=1 -close_fd_mask=2 \
        -artifact_prefix=build/fuzz/ "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target"
done

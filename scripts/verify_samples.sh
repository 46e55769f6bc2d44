#!/usr/bin/env bash
# Checks by exact rays that the cones of every sample relief keep their promise, in every wrap mode,
# format, encoding and MIP level: scripts/verify_samples.sh [RAYS for each map, 1e6] [SIZE, 256x256]
# [SAMPLES, all]. Prints a row for each case (violations in all and in each MIP level), and at last
# cones that are not safe, which must be found out. Exit status 1 if any case is not as expected.
# About 1 s for a million rays and core.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

rays=${1:-1e6}
size=${2:-256x256}
bake=build/release/bin/relievo-bake
samples=${3:-$($bake sample --list | awk '{print $1}')}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0

# check safe|unsafe SAMPLE EXTENSION OPTION...: bakes $folder/height.exr and prints its row.
check() {
    local expected=$1 name=$2 file=$folder/map.$3
    shift 3
    local result=0
    $bake relief "$folder/height.exr" -o "$file" --maps depth,cone --force --quiet "$@"
    $bake verify "$file" --rays "$rays" --json >"$folder/report.json" 2>/dev/null || result=$?
    local counts
    counts=$(grep -o '"violations": *[0-9]*' "$folder/report.json" | grep -o '[0-9]*$' | paste -sd' ')
    printf '%-12s %-66s %s\n' "$name" "$*" "$counts"
    if { [ "$expected" = safe ] && [ $result -ne 0 ]; } ||
        { [ "$expected" = unsafe ] && [ $result -ne 1 ]; }; then
        printf '  ^ expected to be %s\n' "$expected"
        status=1
    fi
}

printf '%s rays for each map, %s texels; violations in all and in each MIP level\n' "$rays" "$size"
for sample in $samples; do
    $bake sample "$sample" -o "$folder/height.exr" --size "$size" --quiet
    for wrap in repeat mirror clamp; do
        for cone in conservative relaxed roof; do
            check safe "$sample" exr --wrap $wrap --cone $cone --mips
            check safe "$sample" exr --wrap $wrap --cone $cone --mips --format half
        done
        for cone in conservative relaxed; do
            for encode in ratio sqrt; do
                for format in u16 u8; do
                    check safe "$sample" png --wrap $wrap --cone $cone --format $format \
                        --encode $encode
                done
            done
        done
    done
done

$bake sample ridge -o "$folder/height.exr" --size "$size" --quiet
check unsafe ridge exr --cone conservative --guarantee texel
check unsafe ridge exr --cone relaxed --method maxima
check unsafe ridge exr --cone relaxed --method policarpo
exit $status

#!/usr/bin/env bash
# Checks by exact rays that the cones of every sample relief keep their promise, in every wrap mode,
# format, encoding and MIP level: scripts/verify_samples.sh [RAYS for each map, 1e6] [SIZE, 256x256]
# [SAMPLES, all] [RECORD, none]. Prints a row for each case (violations in all and in each MIP level),
# and at last cones that are not safe, which must be found out. Exit status 1 if any case is not as
# expected. About 1 s for a million rays and core: with 1e7 rays two to three hours on two cores.
# RECORD is a file that gets a row for each case as expected; a map for which it has one, of the same
# bytes and as many rays, is not checked again, so that a run can be interrupted and taken up.
set -euo pipefail
record=${4:+$(realpath -m "$4")}
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
    local case key result=0
    case=$(printf '%-12s %-66s' "$name" "$*")
    $bake relief "$folder/height.exr" -o "$file" --maps depth,cone --force --quiet "$@"
    key="$(sha256sum <"$file" | cut -c1-16) $rays $case"
    if [ -n "$record" ] && grep -sF -- "$key" "$record"; then
        return
    fi
    $bake verify "$file" --rays "$rays" --json >"$folder/report.json" 2>/dev/null || result=$?
    local counts
    counts=$(grep -o '"violations": *[0-9]*' "$folder/report.json" | grep -o '[0-9]*$' | paste -sd' ')
    echo "$case $counts"
    if { [ "$expected" = safe ] && [ $result -ne 0 ]; } ||
        { [ "$expected" = unsafe ] && [ $result -ne 1 ]; }; then
        printf '  ^ expected to be %s\n' "$expected"
        status=1
    elif [ -n "$record" ]; then
        echo "$key $counts" >>"$record"
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

#!/usr/bin/env bash
# From a height map to pictures: bakes a bundled relief and renders it with several techniques next
# to the exact reference, without a display. Installs the Debian packages that are missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. scripts/setup.sh

install_packages
build release relievo-bake relievo-view

bin=build/release/bin
mkdir -p out
step "$bin/relievo-bake" relief textures/samples/bricks-height.png \
    -o out/bricks.exr
step "$bin/relievo-view" out/bricks.exr --albedo textures/samples/bricks-albedo.png \
    --compare normal,relief,exact,reference --headless --size 360x300 --camera 30,25,1.05 \
    -o out/compare.png --error out/error.exr

echo "$program: out/compare.png  techniques next to the exact picture, with their errors"
echo "$program: out/error.exr    the error of every pixel"
echo "$program: out/bricks.exr   the baked maps (build/release/bin/relievo-bake info out/bricks.exr)"

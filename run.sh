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
step "$bin/relievo-bake" relief textures/samples/cobbles-height.png -o out/cobbles.exr
step "$bin/relievo-view" out/cobbles.exr --albedo textures/samples/cobbles-albedo.png \
    --compare normal,linear,relief,cone,reference --headless -o out/compare.png --error out/error.exr

echo "$program: out/compare.png  techniques next to the exact picture, with their errors"
echo "$program: out/error.exr    the error of every pixel"
echo "$program: out/cobbles.exr  the baked maps (build/release/bin/relievo-bake info out/cobbles.exr)"

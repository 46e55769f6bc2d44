#!/bin/sh
# Draws docs/pictures/shading.png: one relief shaded by both models at several depth scales. Needs a build in
# build/release and the montage of ImageMagick.
#
#   scripts/shading_picture.sh OUT.png
set -eu
cd "$(dirname "$0")/.."
out=${1:?usage: scripts/shading_picture.sh OUT.png}
programs=build/release/bin
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$programs/relievo-bake" relief textures/samples/cobbles-height.png -o "$folder/cobbles.exr" \
    --maps depth,derivative,cone,occlusion --cone roof --quiet
draw() {
    name=$1 scale=$2
    shift 2
    "$programs/relievo-view" "$folder/cobbles.exr" --headless -o "$folder/$name-$scale.png" --quiet \
        --depth-scale "$scale" --size 320x300 --camera 30,38,1.45 --light -60,35 --occlusion baked "$@"
}
pictures=
for scale in 0 0.05 0.2; do
    draw phong $scale --shading blinn-phong --albedo textures/samples/cobbles-albedo.png
    draw dielectric $scale --shading microfacet --roughness 0.35 \
        --albedo textures/samples/cobbles-albedo.png
    draw metal $scale --shading microfacet --roughness 0.4 --metalness 1
    pictures="$pictures -label Blinn–Phong,\ depth\ scale\ $scale $folder/phong-$scale.png"
    pictures="$pictures -label microfacet,\ dielectric $folder/dielectric-$scale.png"
    pictures="$pictures -label microfacet,\ metal $folder/metal-$scale.png"
done
eval montage -font DejaVu-Sans -pointsize 13 -background "'#222222'" -fill white $pictures \
    -tile 3x3 -geometry +3+3 "'$out'"

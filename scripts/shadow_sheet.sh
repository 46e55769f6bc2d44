#!/usr/bin/env bash
# scripts/shadow_sheet.sh OUT.png
# One relief without shadows, with every shadow method and with the exact shadows. Puts the pictures
# together with montage of ImageMagick.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
output=${1:?usage: scripts/shadow_sheet.sh OUT.png}
bin=build/release/bin
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$bin/relievo-bake" sample cobbles -o "$folder/height.png" --size 256x256 --quiet
"$bin/relievo-bake" relief "$folder/height.png" -o "$folder/maps.exr" --quiet \
    --maps depth,derivative,cone,horizon,ellipse
picture() {
    local name=$1
    shift
    "$bin/relievo-view" "$folder/maps.exr" --headless --quiet --size 480x400 --camera 20,50,1.15 \
        --light -50,22 -o "$folder/$name.png" "$@"
}
picture 1
picture 2 --shadow search
picture 3 --shadow soft --light-size 8
picture 4 --shadow horizon --light-size 8
picture 5 --shadow ellipse --light-size 8
picture 6 --shadow soft --light-size 8 --technique reference
montage "$folder"/[1-6].png -tile 3x2 -geometry +2+2 -background '#202020' "$output"

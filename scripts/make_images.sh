#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# make_images.sh [SHEEN [FOLDER]]: draws the pictures of the documents with the command SHEEN (build/release/sheen) into
# FOLDER (docs/images), and the drawings with docs/drawings/. Exit status: 0 all are there, none above 200,000 bytes.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
sheen=${1:-build/release/sheen}
folder=${2:-docs/images}
readonly max_bytes=200000
mkdir -p "$folder"

# The README's: a lacquered knot under a warm key light and a blue one from the side, shaded by the VHDL.
"$sheen" render builtin:torus-knot -o "$folder/hero.png" --method quadratic --device verilator --rotate 0,0,15 \
    --ka .03,.01,.02 --kd .7,.12,.1 --ks 1 --shininess 20 \
    --light -.45,.6,.65 --light-colour 1,.95,.85 --light .85,.2,.45 --light-colour .35,.5,1

"$sheen" render builtin:teapot -o "$folder/teapot.png" --method quadratic --device verilator --size 512x384 \
    --rotate 28,-30,0 --ka .03,.02,.02 --kd .62,.3,.1 --ks .9 --shininess 40 \
    --light -.35,.35,.85 --light-colour 1,.92,.78 --light .95,.1,.35 --light-colour .2,.45,1

# The methods side by side: Phong first, then a column each, picture above error map.
"$sheen" compare builtin:sphere-168 -o "$folder/methods-sphere.png" --methods flat,gouraud,quadratic --devices hls \
    --size 256x256 --rotate 23,0,11 --shininess 50
"$sheen" compare builtin:torus-knot -o "$folder/methods-knot.png" --methods flat,gouraud,quadratic --devices hls \
    --size 256x256 --rotate 30,20,0 --shininess 50

for drawing in docs/drawings/*.py; do
    "${PYTHON:-python3}" "$drawing" "$folder/$(basename "$drawing" .py).svg"
done

for picture in "$folder"/*.png "$folder"/*.svg; do
    bytes=$(stat -c %s "$picture")
    if [[ $bytes -gt $max_bytes ]]; then
        echo "make_images: $picture has $bytes bytes; $max_bytes are the limit" >&2
        exit 1
    fi
    echo "make_images: $picture, $bytes bytes"
done

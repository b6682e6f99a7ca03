#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# demo.sh [small|full]: renders the built-in meshes through every device, compares every pixel word, and says where the
# pictures are. Needs build/release/sheen and its devices (`make demo` builds them). Exit status: 0 all agree, 1 a
# difference or a failure, 2 wrong arguments.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
sheen=build/release/sheen
out=build/demo
case ${1:-full} in
    small) size=160x120 ;;
    full) size=512x512 ;;
    *)
        echo "demo: unknown size '$1': give small or full" >&2
        exit 2
        ;;
esac
mkdir -p "$out"

# One mesh: shaded by the kernels, by the VHDL on GHDL and by the VHDL on Verilator, from the same packets.
show() {
    local name=$1
    shift
    echo
    echo "$name: $size, quadratic shading"
    "$sheen" render "builtin:$name" -o "$out/$name.png" --method quadratic --device hls --size "$size" "$@" \
        --packets "$out/$name.packets" --pixels "$out/$name.hls.pixels" >/dev/null
    for device in ghdl verilator; do
        "$sheen" run "$out/$name.packets" --device "$device" --pixels "$out/$name.$device.pixels" \
            --stats "$out/$name.$device.json" >/dev/null
        if ! cmp -s "$out/$name.hls.pixels" "$out/$name.$device.pixels"; then
            echo "demo: $name on $device differs from the kernels; compare $out/$name.hls.pixels and $out/$name.$device.pixels" >&2
            exit 1
        fi
    done
    local pixels cycles
    pixels=$(($(stat -c %s "$out/$name.hls.pixels") / 8 - 1)) # the last word is the fence's echo
    cycles=$(grep -oP '"cycles": \K[0-9]+' "$out/$name.verilator.json")
    pictures+=("$out/$name.png")
    echo "  kernels = GHDL = Verilator: all $pixels pixels identical; $cycles clock cycles"
}

pictures=()
echo "Sheen: a mesh, shaded by hand-written VHDL"
show torus-knot --rotate 0,0,15 --ka .03,.01,.02 --kd .7,.12,.1 --ks 1 --shininess 20 \
    --light -.45,.6,.65 --light-colour 1,.95,.85 --light .85,.2,.45 --light-colour .35,.5,1
show teapot --rotate 28,-30,0 --ka .03,.02,.02 --kd .62,.3,.1 --ks .9 --shininess 40 \
    --light -.35,.35,.85 --light-colour 1,.92,.78 --light .95,.1,.35 --light-colour .2,.45,1
show sphere-168 --rotate 23,0,11 --shininess 50

echo
echo "flat, Gouraud, quadratic and Phong per pixel, side by side"
"$sheen" compare builtin:sphere-168 --rotate 23,0,11 --shininess 50 --size "$size" --devices reference,verilator \
    -o "$out/methods.png"
pictures+=("$out/methods.png")

echo
echo "Pictures:"
printf '  %s\n' "${pictures[@]}"
echo "The devices agree in every pixel."

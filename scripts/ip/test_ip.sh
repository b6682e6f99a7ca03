#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# test_ip.sh quick|full FOLDER: each core of FOLDER (`make ip`) alone in a temporary folder. Icarus runs its example, which
# must agree with the kernels and must see a wrong word; GHDL takes the VHDL file set; no file names a place of this
# machine. Verilator runs the example of the first core (quick) or of each (full). Exit status: 0 all good, 1 not.
set -euo pipefail

extent=$1
cores=$(realpath "$2")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
ghdl=${GHDL:-ghdl}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
    echo "test-ip: $core: $1" >&2
    [[ $# -lt 2 ]] || tail -n 20 "$2" >&2
    exit 1
}

# expect_words SIMULATOR COMMAND…: the example ran to its end and says so.
expect_words() {
    local simulator=$1
    shift
    "$@" >run.log 2>&1 || fail "the example fails on $simulator" run.log
    grep -q '^example: [0-9]* words, each as the kernels give it$' run.log ||
        fail "the example came to no end on $simulator" run.log
}

tested=0
for folder in "$cores"/*/; do
    core=$(basename "$folder")
    top=sheen_${core//-/_}
    ! grep -rlF -e "$root" -e "${HOME:-$root}/" "$folder" || fail "the file above names a place of this machine"
    cp -r "$folder" "$scratch/$core"
    cd "$scratch/$core"

    iverilog -g2012 -o example example.v "$top.v" >build.log 2>&1 || fail "Icarus refuses it" build.log
    [[ ! -s build.log ]] || fail "Icarus warns" build.log
    sed '3s/^./x/' "$folder/example_words.hex" >example_words.hex
    ! vvp example >run.log 2>&1 || fail "the example doesn't see a wrong word" run.log
    cp "$folder/example_words.hex" .
    expect_words Icarus vvp example

    on="Icarus"
    if [[ $extent == full || $tested -eq 0 ]]; then
        verilator --binary -Wno-lint --top-module example example.v "$top.v" >build.log 2>&1 ||
            fail "Verilator refuses it" build.log
        expect_words Verilator obj_dir/Vexample
        on+=" and Verilator"
    fi

    (cd vhdl && "$ghdl" -a --std=08 --work=sheen $(cat files.txt) && "$ghdl" --synth --std=08 --work=sheen "$top") \
        >build.log 2>&1 || fail "GHDL refuses the VHDL" build.log
    "$root/build/venv/bin/python" -c 'import sys, yaml; yaml.safe_load(open(sys.argv[1]))["targets"]["sim"]' "$top.core" \
        2>build.log || fail "the FuseSoC file is no YAML" build.log
    echo "test-ip: $core: $on: $(sed -n 's/^example: //p' run.log); GHDL takes the VHDL"
    cd "$root"
    tested=$((tested + 1))
done
core=none
[[ $tested -gt 0 ]] || fail "there is no core in $cores; run \`make ip\`"

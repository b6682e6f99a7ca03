#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Proves by induction that accumulator does the same for every family, whatever is at its inputs: GHDL writes both
# architectures as Verilog, yosys compares them register by register, with its own model of ECP5's carry cell.
#
# Environment: GHDL, the VHDL tool. Exit status: 0 proved, 1 not proved or a tool failed.
set -euo pipefail
cd "$(dirname "$0")/.."

readonly ghdl="${GHDL:-ghdl}" work="build/formal"
mapfile -t sources < <(sed 's|^|rtl_vhdl/|' rtl_vhdl/files.txt)
mkdir -p "$work"
"$ghdl" -a --std=08 --work=sheen --workdir="$work" "${sources[@]}" 2> "$work/ghdl.log"

# accumulator's Verilog for a family: verilog WIDTH FAMILY
verilog() {
    "$ghdl" --synth --std=08 --work=sheen --workdir="$work" "-gwidth=$1" "-gfamily=$2" --out=verilog accumulator \
        2>> "$work/ghdl.log" > "$work/$2.v"
}

for width in 1 2 15 16 32; do
    verilog "$width" plain
    verilog "$width" ecp5
    if ! yosys -q -l "$work/accumulator-$width.log" -p "
        read_verilog -sv $work/plain.v
        rename accumulator plain
        read_verilog -sv -overwrite $work/ecp5.v
        rename accumulator ecp5
        setparam -set INJECT1_0 \"NO\" -set INJECT1_1 \"NO\" t:CCU2C
        read_verilog +/ecp5/cells_sim.v
        hierarchy
        proc
        flatten plain ecp5
        opt -purge plain ecp5
        equiv_make plain ecp5 both
        cd both
        opt_clean
        equiv_simple
        equiv_induct
        equiv_status -assert" 2> "$work/yosys.log"; then
        echo "formal: accumulator of $width bits: plain and ecp5 are not proved equal; see $work/accumulator-$width.log" >&2
        exit 1
    fi
    echo "formal: accumulator of $width bits: plain and ecp5 are equal"
done

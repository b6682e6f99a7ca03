#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# vhdl_to_verilog.sh OUT.v COMMAND…: runs a `ghdl --synth` command and keeps its Verilog as OUT.v, whole or not at all.
# What GHDL says is shown only when it fails: on every `attribute latency` it warns, whatever the code.
# Exit status: GHDL's; 1 when it wrote nothing.
set -euo pipefail

out=$1
shift
if ! "$@" >"$out.part" 2>"$out.log" || [ ! -s "$out.part" ]; then
    cat "$out.log" >&2
    echo "vhdl_to_verilog: GHDL made no Verilog for $out" >&2
    exit 1
fi
mv "$out.part" "$out"

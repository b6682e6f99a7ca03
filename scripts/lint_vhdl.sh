#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# lint_vhdl.sh SCRATCH: analyses rtl_vhdl and constraints with GHDL, every warning an error, and checks their style and
# that of testbench with vsg (vsg.yaml). The benches are analysed with the same warnings when they are built.
# Exit status: 0 nothing found, 1 findings.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
ghdl=${GHDL:-ghdl}
scratch=$1
rm -rf "$scratch"
mkdir -p "$scratch"
options=(--std=08 --work=sheen --workdir="$scratch")
# Debian's GHDL has no -Wall.
warnings=(-Wlibrary -Wdefault-binding -Wbinding -Wport -Wreserved -Wnested-comment -Wparenthesis -Wdelayed-checks
    -Wbody -Wspecs -Wuniversal -Wruntime-error -Wshared -Whide -Wunused -Wothers -Wpure -Wstatic -Wport-bounds
    -Wanalyze-assert -Wattribute -Wuseless --warn-error)

# Each files.txt has every source of its folder, users after what they use.
mapfile -t sources < <(sed 's|^|rtl_vhdl/|' rtl_vhdl/files.txt && sed 's|^|constraints/|' constraints/files.txt)
if ! diff <(printf '%s\n' "${sources[@]}" | sort) <(find rtl_vhdl constraints -name '*.vhd' | sort); then
    echo "lint_vhdl: rtl_vhdl/files.txt and constraints/files.txt (<) and their folders (>) differ" >&2
    exit 1
fi
"$ghdl" -a "${options[@]}" "${warnings[@]}" testbench/models/*.vhd "${sources[@]}"
echo "lint_vhdl: ${#sources[@]} files analysed, no warning"

mapfile -t styled < <(find rtl_vhdl constraints testbench -name '*.vhd' -not -path '*/generated/*' | sort)
build/venv/bin/vsg --configuration scripts/vsg.yaml --all_phases --output_format syntastic --filename "${styled[@]}"
echo "lint_vhdl: style of ${#styled[@]} files, no finding"

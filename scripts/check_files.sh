#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Checks the source files as text: an SPDX line first (after #!), at most 400 lines (560 of VHDL,
# whose port maps take one a port), no blanks at a line's end, and
# no note that work is left. Exit status: 0 nothing found, 1 findings, one line each.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
readonly max_lines=400
readonly max_vhdl_lines=560
findings=0

finding() {
    echo "$1"
    findings=$((findings + 1))
}

mapfile -t files < <(find . -name build -prune -o -name .git -prune -o -type f \( -name '*.cpp' -o -name '*.hpp' \
    -o -name '*.vhd' -o -name '*.v' -o -name '*.sv' -o -name '*.py' -o -name '*.sh' -o -name '*.cmake' -o -name '*.yaml' \
    -o -name CMakeLists.txt -o -name Makefile -o -path './.ci/*' \) -printf '%P\n' | sort)
for file in "${files[@]}"; do
    head -n 2 "$file" | grep -v '^#!' | head -n 1 | grep -qE '^(//|--|#) SPDX-License-Identifier: MIT$' ||
        finding "$file:1: the first line is not 'SPDX-License-Identifier: MIT' as a comment"
    lines=$(wc -l <"$file")
    limit=$max_lines
    [[ $file != *.vhd ]] || limit=$max_vhdl_lines
    [[ $lines -le $limit ]] || finding "$file: $lines lines; look for the second idea in it, $limit are the limit"
    while IFS=: read -r number _; do
        finding "$file:$number: blanks at the line's end"
    done < <(grep -nE '[[:blank:]]+$' "$file" || true)
    while IFS=: read -r number text; do
        finding "$file:$number: work left over: $text"
    done < <(grep -nwE 'TO''DO|FIX''ME|XX''X' "$file" || true)
done

[[ $findings -eq 0 ]] || { echo "check_files: $findings findings in ${#files[@]} files" >&2 && exit 1; }
echo "check_files: ${#files[@]} files, no finding"

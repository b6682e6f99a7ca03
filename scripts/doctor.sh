#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# doctor.sh            prints a table of every tool: name, version found, version needed, how to get it.
# doctor.sh --missing  prints the Debian packages of the system tools that are missing or too old, one a line.
#
# The tools stand in tools.txt, requirements.txt and requirements-fpga.txt. AC_TYPES names the folder of the ac_types headers.
# Exit status of the table: 0 everything is there, 1 something is missing or too old.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
ac_types=${AC_TYPES:-$root/build/ac_types/4.8}

# probe COMMAND: the first number that COMMAND prints, or nothing when it fails.
probe() {
    local text
    text=$(bash -c "$1" 2>/dev/null) || return 0
    grep -oE '[0-9]+(\.[0-9]+)*' <<<"$text" | sed -n 1p || true
}

# serves FOUND NEEDED: is there a version, and is it high enough?
serves() {
    [[ -n $1 ]] && { [[ $2 == any ]] || printf '%s\n%s\n' "$2" "$1" | sort --version-sort --check=quiet; }
}

# system_tools VISITOR: calls VISITOR name packages needed found for each line of tools.txt.
system_tools() {
    local name packages needed command
    while IFS='|' read -r name packages needed command; do
        [[ $name == '#'* || -z $name ]] && continue
        read -r packages <<<"$packages"
        "$1" "$(xargs <<<"$name")" "$packages" "$(xargs <<<"$needed")" "$(probe "$command")"
    done <"$here/tools.txt"
}

print_missing() {
    serves "$4" "$3" || printf '%s\n' $2
}

missing=0

# row NAME FOUND NEEDED REMEDY STATUS(0: serves, 1: missing, 2: comes when it is first needed)
row() {
    local found=${2:-missing} remedy=$4
    if [[ $5 -eq 0 ]]; then
        remedy=ok
    elif [[ $5 -eq 1 ]]; then
        missing=$((missing + 1))
    fi
    printf '%-16s %-10s %-8s %s\n' "$1" "$found" "$3" "$remedy"
}

system_row() {
    local status=0 found=$4
    serves "$4" "$3" || status=1
    [[ $found == 0 ]] && found=found
    row "$1" "$found" "$3" "apt-get install $2" "$status"
}

# python_rows FILE REMEDY STATUS(of one that is missing)
python_rows() {
    local requirement name needed found status
    while read -r requirement; do
        name=${requirement%%==*}
        needed=${requirement##*==}
        found=$("$root/build/venv/bin/python" -c \
            "import importlib.metadata, sys; print(importlib.metadata.version('$name'))" 2>/dev/null) || found=
        status=0
        [[ $found == "$needed" ]] || status=$3
        row "$name" "$found" "$needed" "$2" "$status"
    done < <(grep -vE '^(#|$)' "$here/$1")
}

ac_types_row() {
    local found='' status=0
    [[ -f $ac_types/ac_fixed.h ]] && found=found
    [[ -n $found ]] || status=1
    row "ac_types" "$found" any "make setup, or AC_TYPES=folder of ac_fixed.h" "$status"
}

if [[ ${1:-} == --missing ]]; then
    system_tools print_missing
    exit 0
fi

printf '%-16s %-10s %-8s %s\n' tool found needed 'how to get it'
system_tools system_row
python_rows requirements.txt "make setup" 1
python_rows requirements-fpga.txt "the first make fpga brings it" 2
ac_types_row
if [[ $missing -gt 0 ]]; then
    echo "doctor: $missing missing or too old; \`make setup\` gets them all"
    exit 1
fi
echo "doctor: everything is there"

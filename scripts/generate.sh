#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# generate.sh TOOLS TARGET                  runs every generator TOOLS/make_* with TARGET as its output folder
# generate.sh --check TOOLS TARGET SCRATCH  runs them into SCRATCH and compares: TARGET must hold the same files
#
# Exit status: 0 written, or fresh; 1 stale, naming each pair of files that differ.
set -euo pipefail

run_generators() {
    mkdir -p "$2"
    for tool in "$1"/make_*; do
        "$tool" "$2"
    done
}

if [[ $1 != --check ]]; then
    run_generators "$1" "$2"
    echo "generate: $2/ written: $(ls "$2" | xargs)"
    exit 0
fi

rm -rf "$4"
run_generators "$2" "$4"
if ! diff --unified --new-file "$3" "$4"; then
    diff --brief "$3" "$4" >&2 || true
    echo "check-generated: $3/ is stale against $4/; run \`make generate\` and commit the result" >&2
    exit 1
fi
echo "check-generated: $(ls "$3" | wc -l) files in $3/ are what the generators write"
